// Paper: Figures 2–8 of Afferrante & Ciavarella (2009), computed when they are looked at.

export function startPaper() {}
