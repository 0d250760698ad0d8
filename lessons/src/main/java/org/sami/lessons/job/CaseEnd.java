package org.sami.lessons.job;

/** How a case can go, held against the solution; in files in small letters with hyphens. */
enum CaseEnd {
    SAME,
    DIFFERENT,
    NEVER_ENDS,
    ENDS_EARLY,
    ASKS_NOBODY,
    ENDLESS,
    REFUSED
}
