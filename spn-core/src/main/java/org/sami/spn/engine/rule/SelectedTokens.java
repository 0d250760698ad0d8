package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.model.Action;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;

/**
 * What a firing will do.
 *
 * <p>Implements R-OUT-6.
 */
final class SelectedTokens {
    /** A returned token that a firing uses though no token of the parent stands for it. */
    record UsedReturn(Instance instance, Token token) {}

    final List<PlacedToken> removed = new ArrayList<>(4);
    final List<List<Token>> added = new ArrayList<>(4);
    final List<TokenMove> moves = new ArrayList<>(4);
    /** Named tokens that were made for the edge at hand: copies of them are not added to it again. */
    final List<Token> made = new ArrayList<>(0);

    final List<UsedReturn> usedReturns = new ArrayList<>(0);
    final List<String> shortOf = new ArrayList<>(0);

    private final PickedTokens removedOnce;
    private final PickedTokens addedByEdge;

    /**
     * Nothing yet.
     *
     * @param removedOnce an empty set, for as long as tokens are selected
     * @param addedByEdge another
     */
    SelectedTokens(PickedTokens removedOnce, PickedTokens addedByEdge) {
        this.removedOnce = removedOnce;
        this.addedByEdge = addedByEdge;
    }

    /** Begins with the next edge. */
    void nextEdge() {
        made.clear();
        addedByEdge.clear();
    }

    /** Applies an action to one selected token of the pool. */
    void use(PlacedToken e, Action action, CompiledTransition.Out out, List<Token> added) {
        Optional<String> from = Optional.empty();
        if (action != Action.ADD && removedOnce.add(e)) {
            removed.add(e);
            from = e.place().place.inMoves;
        }
        Optional<String> to = Optional.empty();
        if (action != Action.CONSUME && !made.contains(e.token) && addedByEdge.add(e)) {
            added.add(e.token);
            to = out.place().inMoves;
        }
        if (from.isPresent() || to.isPresent()) {
            moves.add(new TokenMove(e.token, from, to));
        }
    }

    /** Makes a token for an edge. */
    void make(Token token, CompiledTransition.Out out, List<Token> added) {
        added.add(token);
        if (token != Token.GENERIC) {
            made.add(token);
        }
        moves.add(new TokenMove(token, Optional.empty(), out.place().inMoves));
    }
}
