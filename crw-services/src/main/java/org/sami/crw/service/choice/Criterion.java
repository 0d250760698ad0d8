package org.sami.crw.service.choice;

import java.util.Locale;

/** What a solution is the best by (appendix .2.3, Optimize). The names are the constants of the vocabulary's type Criterion. */
public enum Criterion {
    /** How soon the answer is there. */
    COMPUTATION_TIME,
    /** How soon the last boat is done. */
    EXECUTION_TIME,
    /** How far boats keep from obstacles and from each other. */
    EXECUTION_SAFETY,
    /** How little all boats drive together. */
    EXECUTION_EFFICIENCY;

    /** The criterion as people say it. */
    public String words() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
