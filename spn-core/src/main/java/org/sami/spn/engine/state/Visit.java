package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.protocol.Token;

/** One entry of tokens, or of nobody, into a place (R-VIS-1). */
public final class Visit {
    public final long id;
    public final PlaceState place;
    public final boolean byNobody;
    /** The tokens that entered, each as often as it entered. */
    public final List<Token> entered;
    /** How many of its tokens have not left. */
    public int live;

    public @Nullable PlacedToken first;
    private @Nullable PlacedToken last;
    public boolean ended;
    public final List<SentActivation> sent = new ArrayList<>(1);
    /** Dynamic instances, none for most places. */
    public List<Instance> instances = List.of();
    /** Whether an instance runs or was aborted: its tokens are outside every pool. */
    public boolean held;
    /** Whether a firing that speaks of sub-mission tokens has used its completion. */
    public boolean used;
    /** For how many of its tokens it is the last ended visit of the place. */
    public int remembered;

    public @Nullable Visit previous;
    public @Nullable Visit next;

    public Visit(long id, PlaceState place, List<Token> entered) {
        this.id = id;
        this.place = place;
        this.byNobody = entered.isEmpty();
        this.entered = entered;
    }

    /** Puts one of its tokens into the marking. */
    public void enter(Token token, long order) {
        PlacedToken e = new PlacedToken(token, order, place, this);
        place.add(e);
        if (e.kind != PlacedToken.GENERIC) {
            for (CompiledTransition t : place.place.barriers) {
                place.mission.transition(t.index).allReports().entered(token);
            }
        }
    }

    public void add(PlacedToken e) {
        live++;
        e.previousOfVisit = last;
        if (last == null) {
            first = e;
        } else {
            last.nextOfVisit = e;
        }
        last = e;
    }

    public void remove(PlacedToken e) {
        live--;
        if (e.previousOfVisit == null) {
            first = e.nextOfVisit;
        } else {
            e.previousOfVisit.nextOfVisit = e.nextOfVisit;
        }
        if (e.nextOfVisit == null) {
            last = e.previousOfVisit;
        } else {
            e.nextOfVisit.previousOfVisit = e.previousOfVisit;
        }
    }

    /** Whether a copy of a proxy or task token that entered by it is still there. */
    public boolean has(Token token) {
        for (PlacedToken e = place.find(token); e != null; e = e.nextCopy) {
            if (e.visit == this) {
                return true;
            }
        }
        return false;
    }

    public boolean hasInstances() {
        return !instances.isEmpty();
    }

    /** Whether it has instances and all are complete. */
    public boolean complete() {
        if (instances.isEmpty()) {
            return false;
        }
        for (Instance i : instances) {
            if (i.status != Instance.Status.COMPLETE) {
                return false;
            }
        }
        return true;
    }

    public boolean hasRunning() {
        for (Instance i : instances) {
            if (i.status == Instance.Status.RUNNING) {
                return true;
            }
        }
        return false;
    }

    /** Whether an instance was aborted and none runs any longer. */
    public boolean leftByAborted() {
        boolean aborted = false;
        for (Instance i : instances) {
            if (i.status == Instance.Status.RUNNING) {
                return false;
            }
            aborted |= i.status == Instance.Status.ABORTED;
        }
        return aborted;
    }

    public boolean hasSubTokens() {
        for (Instance i : instances) {
            if (!i.returned.isEmpty()) {
                return true;
            }
        }
        return false;
    }

    public void setHeld(boolean value) {
        if (held == value) {
            return;
        }
        held = value;
        for (PlacedToken e = first; e != null; e = e.nextOfVisit) {
            place.hold(e.kind, value ? 1 : -1);
        }
    }
}
