package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.protocol.Token;

/** One entry of tokens, or of nobody, into a place (R-VIS-1). */
public final class Visit {
    /** Bits of a number. */
    private static final int WORD = Long.SIZE;

    public final long id;
    public final PlaceState place;
    public final boolean byNobody;
    /** The tokens that entered, each as often as it entered. */
    public final List<Token> entered;
    /** Order of entry of the first of them; they entered one after the other. */
    private long firstOrder;
    /** Which of the first 64 have not left: one bit for each. */
    private long standing;
    /** The same of the others, 64 a number; null where no more entered. */
    private long @Nullable [] othersStanding;
    /** Neighbours among the visits that have tokens in the place, in order of entry. */
    @Nullable
    Visit previousHere;

    @Nullable
    Visit nextHere;

    public boolean ended;
    /** The first activation that was sent for it, which knows the next: most visits have one, and copies of states have no list for each. */
    private @Nullable SentActivation firstSent;

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

    /**
     * Puts all its tokens into the marking.
     *
     * @param orderOfFirst order of entry of the first; each other one's is greater by one than that of the token before it
     */
    public void enter(long orderOfFirst) {
        int words = (entered.size() + WORD - 1) / WORD;
        othersStanding = words > 1 ? new long[words - 1] : null;
        firstOrder = orderOfFirst;
        for (int i = 0; i < entered.size(); i++) {
            stand(i);
        }
        enterPlace();
    }

    /**
     * Puts those of its tokens into the marking that have not left since, as it stands in a state that is read.
     *
     * @param orderOfFirst as for the other {@code enter}
     * @param positions of these tokens among all that entered, in order
     */
    public void enter(long orderOfFirst, List<Integer> positions) {
        int words = (entered.size() + WORD - 1) / WORD;
        othersStanding = words > 1 ? new long[words - 1] : null;
        firstOrder = orderOfFirst;
        positions.forEach(this::stand);
        enterPlace();
    }

    /** Puts into the marking what stands there by the visit of which this is a copy. */
    void enterAs(Visit old) {
        firstOrder = old.firstOrder;
        standing = old.standing;
        othersStanding = old.othersStanding == null ? null : old.othersStanding.clone();
        enterPlace();
    }

    private void stand(int index) {
        if (index < WORD) {
            standing |= 1L << index;
        } else {
            others()[index / WORD - 1] |= 1L << index;
        }
    }

    private long[] others() {
        return Objects.requireNonNull(othersStanding, "the numbers of a visit of more than 64 tokens");
    }

    private void enterPlace() {
        place.add(this);
        for (CompiledTransition t : place.place.barriers) {
            Barrier reports = place.mission.transition(t.index).allReports();
            for (int i = nextStanding(0); i >= 0; i = nextStanding(i + 1)) {
                if (kindAt(i) != PlacedToken.GENERIC) {
                    reports.entered(entered.get(i));
                }
            }
        }
    }

    /** One of its tokens leaves. */
    void leave(int index) {
        if (index < WORD) {
            standing &= ~(1L << index);
        } else {
            others()[index / WORD - 1] &= ~(1L << index);
        }
    }

    /** The first position from one on whose token stands in the place; -1 where there is none. */
    int nextStanding(int from) {
        if (from < WORD) {
            long left = standing >>> from;
            if (left != 0) {
                return from + Long.numberOfTrailingZeros(left);
            }
        }
        if (othersStanding == null) {
            return -1;
        }
        int at = Math.max(from, WORD);
        for (int word = at / WORD - 1; word < othersStanding.length; word++) {
            long left = othersStanding[word] >>> at; // of a shift the lowest six bits count
            if (left != 0) {
                return at + Long.numberOfTrailingZeros(left);
            }
            at = (word + 2) * WORD;
        }
        return -1;
    }

    /** Whether all its tokens have left. */
    public boolean hasLeft() {
        return nextStanding(0) < 0;
    }

    int kindAt(int index) {
        return PlacedToken.kindOf(entered.get(index));
    }

    long orderOf(int index) {
        return firstOrder + index;
    }

    /** Its tokens that have not left, in order of entry. */
    public List<Token> left() {
        List<Token> tokens = new ArrayList<>(entered.size());
        for (int i = nextStanding(0); i >= 0; i = nextStanding(i + 1)) {
            tokens.add(entered.get(i));
        }
        return tokens;
    }

    /** The same as they stand in the place. */
    public List<PlacedToken> standing() {
        List<PlacedToken> tokens = new ArrayList<>(entered.size());
        addStanding(tokens);
        return tokens;
    }

    void addStanding(List<PlacedToken> into) {
        for (int i = nextStanding(0); i >= 0; i = nextStanding(i + 1)) {
            into.add(new PlacedToken(this, i));
        }
    }

    /** Whether a copy of a proxy or task token that entered by it is still there. */
    public boolean has(Token token) {
        if (entered.size() > PlaceState.FEW) {
            for (PlacedToken e : place.copies(token)) {
                if (e.visit == this) {
                    return true;
                }
            }
            return false;
        }
        return indexOf(token, 0) >= 0;
    }

    /** The first position from one on at which that token stands; -1 where there is none. */
    int indexOf(Token token, int from) {
        for (int i = nextStanding(from); i >= 0; i = nextStanding(i + 1)) {
            if (entered.get(i).equals(token)) {
                return i;
            }
        }
        return -1;
    }

    /** An activation was sent for it. */
    public void addSent(SentActivation activation) {
        if (firstSent == null) {
            firstSent = activation;
            return;
        }
        SentActivation last = firstSent;
        for (SentActivation s = last.next(); s != null; s = s.next()) {
            last = s;
        }
        last.isFollowedBy(activation);
    }

    /** The first activation that was sent for it; null where none was. */
    public @Nullable SentActivation firstSent() {
        return firstSent;
    }

    /** How many activations were sent for it. */
    public int countSent() {
        int n = 0;
        for (SentActivation s = firstSent; s != null; s = s.next()) {
            n++;
        }
        return n;
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
        for (int i = nextStanding(0); i >= 0; i = nextStanding(i + 1)) {
            place.hold(kindAt(i), value ? 1 : -1);
        }
    }
}
