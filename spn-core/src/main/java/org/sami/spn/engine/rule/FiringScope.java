package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.Visit;

/**
 * What a firing may speak of in its in places: how far it reaches, and which returns it checks the values of. Those
 * bind it to the tokens of their visit, or of their return, and to no others.
 *
 * <p>Implements R-SHR-4, R-RET-2.
 */
public final class FiringScope {
    public static final FiringScope FREE = new FiringScope(Reach.FREE, List.of());
    private static final FiringScope ABORTED = new FiringScope(Reach.ABORTED, List.of());
    private static final FiringScope ALL = new FiringScope(Reach.ALL, List.of());

    public final Reach reach;
    /** Returns whose values the used occurrences tell. */
    public final List<Return> checked;

    private FiringScope(Reach reach, List<Return> checked) {
        this.reach = reach;
        this.checked = checked;
    }

    public static FiringScope of(Reach reach) {
        return switch (reach) {
            case FREE -> FREE;
            case ABORTED -> ABORTED;
            case ALL -> ALL;
        };
    }

    /** The scope of a firing that uses these occurrences. */
    public static FiringScope of(Reach reach, List<PendingOccurrence> used) {
        List<Return> checked = List.of();
        for (PendingOccurrence p : used) {
            if (p.told != null && !checked.contains(p.told)) {
                checked = checked.isEmpty() ? new ArrayList<>(1) : checked;
                checked.add(p.told);
            }
        }
        return checked.isEmpty() ? of(reach) : new FiringScope(reach, checked);
    }

    /** The only visit that it may speak of in a place; null where it is bound to none. */
    public @Nullable Visit visitIn(PlaceState place) {
        for (Return r : checked) {
            if (r.place() == place && r.visit() != null) {
                return r.visit();
            }
        }
        return null;
    }

    /** Whether it can only speak of what a return of a static instance brought back. */
    public boolean needsReturn(SharedRun run) {
        return switch (reach) {
                    case FREE -> true;
                    case ABORTED -> run.instance.status != Instance.Status.ABORTED;
                    case ALL -> false;
                }
                || checkedOf(run) != null;
    }

    /** The return of a static instance whose value it checks; null where it checks none. */
    @Nullable
    Return checkedOf(SharedRun run) {
        for (Return r : checked) {
            if (r.instance == run.instance) {
                return r;
            }
        }
        return null;
    }
}
