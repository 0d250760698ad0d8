package org.sami.crw.handler.motion;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;

/**
 * What the operator has answered about the ways on which an activation sends boats, in the mission's memory: nobody is asked again after a restart. Of moves that a
 * boat makes one after another, as to its tasks, each has an answer of its own.
 */
record WayAnswers(Activation activation, HandlerContext context) {
    /**
     * Whether a move may be made; empty where that was not asked, and where nobody answered and the move is ordered again. Journals from before 2026-11-28 keep one
     * answer for all boats of the activation; those of earlier versions have a no of the operator where nobody answered.
     */
    Optional<WayAnswer> of(DomainQuestion kind, Move move) {
        return at(key(kind, move))
                .or(() -> at(key(kind)))
                .filter(answer -> answer != WayAnswer.NOBODY || !context.orderedAgain());
    }

    /** Why a move may not be made, whatever was doubted; empty where it may. */
    Optional<String> refusal(Move move) {
        return Arrays.stream(DomainQuestion.values())
                .filter(DomainQuestion::isAboutWays)
                .flatMap(kind -> of(kind, move).stream())
                .filter(answer -> answer != WayAnswer.YES)
                .map(WayAnswer::reason)
                .findFirst();
    }

    /** Has the mission remember the answer for each move. */
    void remember(DomainQuestion kind, List<Move> moves, WayAnswer answer) {
        context.post(moves.stream()
                .<Input>map(move -> new Input.Remember(activation.mission(), key(kind, move), answer.remembered()))
                .toList());
    }

    private Optional<WayAnswer> at(String key) {
        return context.query(view -> view.memory(activation.mission(), key)).flatMap(WayAnswer::of);
    }

    private String key(DomainQuestion kind) {
        return "way/" + kind.kind() + "/" + activation.id();
    }

    private String key(DomainQuestion kind, Move move) {
        String boat = move.addressee().boat();
        String id = move.command().commandId();
        String usual = CommandMemory.id(activation, boat);
        return key(kind) + "/" + boat + (id.startsWith(usual) ? id.substring(usual.length()) : "");
    }
}
