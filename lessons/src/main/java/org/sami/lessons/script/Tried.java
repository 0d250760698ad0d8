package org.sami.lessons.script;

import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Tries an edit, to find the ids that it gives. */
final class Tried {
    private Tried() {}

    /** A plan as the edit makes it. */
    static Plan plan(Edit edit, Project project, String plan, Vocabulary vocabulary) throws ScriptRefusedException {
        EditResult result = edit.apply(project, vocabulary);
        if (result instanceof EditResult.Refused refused) {
            throw new ScriptRefusedException("", refused.message());
        }
        return result.project().flatMap(p -> p.plan(plan)).orElseThrow();
    }
}
