package org.sami.spn.analysis;

import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** For the code of a check a project in which it must be found, and one like it in which it must not. */
record PlanCheckCase(String code, Project bad, Project good, Vocabulary words) {
    PlanCheckCase(String code, Project bad, Project good) {
        this(code, bad, good, CheckWords.WORDS);
    }

    @Override
    public String toString() {
        return code;
    }
}
