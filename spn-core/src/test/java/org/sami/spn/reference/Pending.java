package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/** An occurrence that a transition received and has not used (R-PEND-1). */
final class Pending {
    final Transition transition;
    final InputEventSpec event;
    final Occurrence occurrence;
    /** Boats and tasks that its question named too, and that were gone when it came: it is as if it did not name them. */
    final List<Token> gone = new ArrayList<>();
    /** Boats and tasks that it named and that left since. */
    final List<Token> struck = new ArrayList<>();
    /** Of an answer: whom it names and who was there when it arrived. */
    final List<Token> stood = new ArrayList<>();

    /** The return whose value it tells: kept in order, never replaced; empty for all other occurrences. */
    Optional<Returned> told = Optional.empty();
    /** Whether it tells of an aborted child. */
    boolean ofAborted;
    /** The visit whose child was aborted: it is told as an answer to that visit, though to no activation of it. */
    Optional<Visit> childOf = Optional.empty();

    Pending(Transition transition, InputEventSpec event, Occurrence occurrence) {
        this.transition = transition;
        this.event = event;
        this.occurrence = occurrence;
    }

    boolean isAnswer() {
        return occurrence.activation() != Ids.NONE;
    }

    /** The visit that it answers; empty for news. */
    Optional<Visit> answeredVisit(World world) {
        return isAnswer() ? Optional.of(world.visitOfActivation.get(occurrence.activation())) : childOf;
    }

    /** Whether it named anybody who was there when it came. */
    boolean namesSomebody() {
        return !named().isEmpty();
    }

    private List<Token> named() {
        List<Token> named = new ArrayList<>(ofAborted ? Names.ofAborted(occurrence) : Names.of(occurrence));
        named.removeAll(gone);
        return named;
    }

    /** Whom it names and who was not struck. */
    List<Token> names() {
        List<Token> names = named();
        names.removeAll(struck);
        return names;
    }
}
