package org.sami.domain.mistake;

import org.sami.spn.edit.Edit;

/**
 * A mistake that an author makes in a plan that was right.
 *
 * @param name what the author did wrong, in a few words; unique
 * @param plan id of the right plan
 * @param edit what makes the mistake
 * @param code of the finding that names it; empty text where no check can know
 * @param element id of an element that the finding is about
 * @param deep whether only running the plan shows it
 */
record AuthorMistake(String name, String plan, Edit edit, String code, String element, boolean deep) {
    /** A mistake that the live checks find. */
    static AuthorMistake of(String name, String plan, String code, String element, Edit edit) {
        return new AuthorMistake(name, plan, edit, code, element, false);
    }

    /** A mistake that the deep checks find. */
    static AuthorMistake deep(String name, String plan, String code, String element, Edit edit) {
        return new AuthorMistake(name, plan, edit, code, element, true);
    }

    /** Whether a check is expected to find it. */
    boolean isFound() {
        return !code.isEmpty();
    }

    @Override
    public String toString() {
        return name;
    }
}
