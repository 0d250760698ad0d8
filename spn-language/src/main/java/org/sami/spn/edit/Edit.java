package org.sami.spn.edit;

import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * One change of a project. An edit is a value: it holds ids and new contents, no project, and can be applied to any project. Projects are
 * immutable, so that undo is keeping the old one ({@link EditHistory}).
 */
public interface Edit {
    /** What it does, for an undo menu: a few words without a full stop, such as {@code Add place "go"}. */
    String label();

    /**
     * Changes a project. Callers use {@link #apply}, which also takes along what lost its ground and refuses what could not be saved.
     *
     * @throws EditRefusedException with one sentence on what is not possible and where
     */
    Project change(Project project, EditContext context) throws EditRefusedException;

    /**
     * Applies this edit. The result is whole or refused: never a project that could not be written and read back. What no longer has a
     * meaning are removed as well and reported: edges without an end, places in a layout, steps of test cases.
     */
    default EditResult apply(Project project, Vocabulary vocabulary) {
        EditContext context = new EditContext(vocabulary);
        try {
            Project changed = context.settle(project, change(project, context));
            return EditResult.Done.of(project, changed, context.remarks());
        } catch (EditRefusedException e) {
            return new EditResult.Refused(e.reason());
        }
    }
}
