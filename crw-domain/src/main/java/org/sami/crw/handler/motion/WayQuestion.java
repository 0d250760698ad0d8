package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.ListIterator;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.decision.AskedActivation;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * A question about the ways on which an activation sends boats, and the moves that wait for its answer. The answer is remembered for each boat in
 * the mission's memory. For the fleet's thread.
 *
 * @param kind what is doubted
 * @param sender sends or refuses the moves
 * @param doubted the boats that wait; changes when a mission takes them back
 */
record WayQuestion(
        DomainQuestion kind, Activation activation, HandlerContext context, MoveSender sender, List<Doubted> doubted) {
    private static final int NAMED = 3;
    private static final double MILLIS_PER_S = 1000;

    /** A move, and what is wrong with its way. */
    record Doubted(Move move, WayDoubt doubt) {
        /** The boat's id. */
        String boat() {
            return move.addressee().boat();
        }
    }

    /** What the question is about, as the engine knows it. */
    String about() {
        return AskedActivation.of(activation).subject();
    }

    /** Whether it is about boats that came back too often. */
    boolean isFutile() {
        return kind == DomainQuestion.FUTILE_WAY || kind == DomainQuestion.ONE_WAY;
    }

    /**
     * Asks the operator.
     *
     * @param waitS how long the answer can wait, in seconds; empty where it can without end
     */
    void ask(OptionalDouble waitS) {
        List<String> all =
                doubted.stream().map(one -> one.doubt().words()).distinct().toList();
        String doubts = all.stream().limit(NAMED).collect(Collectors.joining("; "));
        int more = all.size() - NAMED;
        context.post(new Input.AskOperator(
                kind.kind(),
                about(),
                doubts + (more > 0 ? "; and " + more + " boats more" : "") + ". Send "
                        + (doubted.size() == 1 ? "it" : "them") + (isFutile() ? " without coming home first?" : "?")
                        + waitS.stream().mapToObj(this::deadline).collect(Collectors.joining()),
                Priority.HIGH,
                List.of(),
                waitS.stream()
                        .mapToObj(seconds -> new Input.AskOperator.Unanswered(false, (long) (seconds * MILLIS_PER_S)))
                        .findFirst()));
    }

    private String deadline(double waitS) {
        return String.format(
                Locale.ROOT,
                " Without an answer %s home after %.0f s, while the charge lasts for that",
                doubted.size() == 1 ? "it comes" : "those in the air come",
                waitS);
    }

    /** Those of its moves for which something holds; they are taken out of it. */
    WayQuestion taking(Predicate<Move> which) {
        List<Doubted> taken =
                doubted.stream().filter(one -> which.test(one.move())).toList();
        doubted.removeAll(taken);
        return new WayQuestion(kind, activation, context, sender, new ArrayList<>(taken));
    }

    /** Takes the boats out about which the operator has given this answer already; empty where there are none. */
    Optional<WayQuestion> takeAnswered(WayAnswer answer) {
        List<Doubted> answered = doubted.stream()
                .filter(one -> answers()
                        .of(kind, one.move())
                        .filter(known -> known == answer)
                        .isPresent())
                .toList();
        doubted.removeAll(answered);
        return answered.isEmpty()
                ? Optional.empty()
                : Optional.of(new WayQuestion(kind, activation, context, sender, new ArrayList<>(answered)));
    }

    /** Has the mission remember the answer for each move, so that nobody is asked again after a restart of the base. */
    void remember(WayAnswer answer) {
        answers().remember(kind, doubted.stream().map(Doubted::move).toList(), answer);
    }

    private WayAnswers answers() {
        return new WayAnswers(activation, context);
    }

    /** Sends all that wait. */
    void send() {
        sender.send(activation, context, doubted.stream().map(Doubted::move).toList());
    }

    /** Answers for all that wait that they are not sent. */
    void refuse(String reason) {
        doubted.forEach(one -> sender.refuse(
                activation, context, one.move(), reason + ": " + one.doubt().words()));
    }

    /** The moves that wait. */
    Stream<HeldMove> moves() {
        return doubted.stream().map(one -> new HeldMove(activation, context, one.move()));
    }

    /** Replaces each move by what is left of it; returns those of which nothing is. */
    List<HeldMove> reduce(Function<HeldMove, Optional<HeldMove>> left) {
        List<HeldMove> taken = new ArrayList<>();
        for (ListIterator<Doubted> all = doubted.listIterator(); all.hasNext(); ) {
            Doubted one = all.next();
            HeldMove whole = new HeldMove(activation, context, one.move());
            Optional<HeldMove> rest = left.apply(whole);
            if (rest.isPresent()) {
                all.set(new Doubted(rest.get().move(), one.doubt()));
            } else {
                taken.add(whole);
                all.remove();
            }
        }
        return taken;
    }
}
