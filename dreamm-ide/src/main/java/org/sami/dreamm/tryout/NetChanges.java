package org.sami.dreamm.tryout;

import org.sami.dreamm.document.DocumentChange;

/** Whether a change of the document makes plans run otherwise: layout, notes, names of plans and test cases do not. */
public final class NetChanges {
    private NetChanges() {}

    /** Whether some plan, or the project's variables, run otherwise after a change. */
    public static boolean in(DocumentChange change) {
        return change.isOpened()
                || !change.before().globals().equals(change.after().globals())
                || change.plans().stream()
                        .anyMatch(id -> !RunContent.runs(change.before().plan(id))
                                .equals(RunContent.runs(change.after().plan(id))));
    }
}
