package org.sami.dreamm.tryout;

import java.util.List;
import java.util.Optional;
import org.sami.dreamm.document.DocumentChange;
import org.sami.spn.model.Plan;

/** Whether a change of the document makes plans run otherwise: layout, notes, names of plans and test cases do not. */
public final class NetChanges {
    private NetChanges() {}

    /** Whether some plan, or the project's variables, run otherwise after a change. */
    public static boolean in(DocumentChange change) {
        return change.isOpened()
                || !change.before().globals().equals(change.after().globals())
                || change.plans().stream()
                        .anyMatch(id -> !runs(change.before().plan(id))
                                .equals(runs(change.after().plan(id))));
    }

    private static List<Object> runs(Optional<Plan> plan) {
        return plan.map(p -> List.<Object>of(
                        p.places(), p.transitions(), p.inEdges(), p.outEdges(), p.variables(), p.reads(), p.tasks()))
                .orElse(List.of());
    }
}
