package org.sami.spn.wizard;

import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.flow.NamedTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.WaysBack;

/**
 * The requirements that make sense on an edge and do not stand there yet, the likeliest first: what the plan's events need; relevant tokens
 * only where an input event names some; kinds of tokens that come there; and on a further edge into a transition, that nobody is left there.
 */
public final class SoundRequirements {
    private static final InRequirement NO_PROXY = InRequirement.of(TokenKind.ANY_PROXY, Match.ZERO, 0);
    private static final InRequirement NO_TASK = InRequirement.of(TokenKind.ANY_TASK, Match.ZERO, 0);

    private final Plan plan;
    private final Vocabulary vocabulary;
    private final ComingTokens coming;
    private final ComputedRequirements computed;

    /** The requirements of a plan of a project. */
    public SoundRequirements(Project project, Plan plan, Vocabulary vocabulary, AuthoringLibrary library) {
        this.plan = Objects.requireNonNull(plan, "plan");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        coming = new ComingTokens(project, plan, vocabulary);
        computed = new ComputedRequirements(plan, vocabulary, library);
    }

    /** Whether an input event of a transition can name tokens: without one there are no relevant tokens (thesis 3.1). */
    public boolean namesTokens(String transition) {
        return plan.transition(transition).stream()
                .flatMap(t -> t.inputs().stream())
                .flatMap(i -> vocabulary.event(i.type()).stream())
                .anyMatch(e -> !NamedTokens.of(e).isEmpty());
    }

    /** What can be asked for on an edge into a transition. */
    public List<InRequirement> in(InEdge edge) {
        Set<InRequirement> sound = new LinkedHashSet<>();
        boolean further = plan.inEdgesOf(edge.transition()).stream()
                .anyMatch(e -> !e.id().equals(edge.id()) && !e.requirements().isEmpty() && WaysBack.isWay(e));
        boolean names = namesTokens(edge.transition());
        if (further && !names) {
            addZeros(edge, sound);
        }
        sound.addAll(computed.in(edge.id()));
        if (names) {
            sound.add(InRequirement.allRelevant());
        }
        for (TokenType kind : EnumSet.of(TokenType.PROXY, TokenType.TASK)) {
            if (coming.comes(kind, edge.place())) {
                sound.add(InRequirement.of(kind(kind), Match.AT_LEAST, 1));
            }
        }
        if (further) {
            addZeros(edge, sound);
        }
        sound.removeIf(r -> r.kind() == TokenKind.GENERIC
                || r.kind() == TokenKind.UNCONDITIONAL
                || edge.requirements().stream().anyMatch(there -> there.kind() == r.kind()));
        return List.copyOf(sound);
    }

    /** That nobody is left, first of the kind that another edge waits for. */
    private void addZeros(InEdge edge, Set<InRequirement> sound) {
        boolean tasks = plan.inEdgesOf(edge.transition()).stream()
                .filter(e -> !e.id().equals(edge.id()))
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.ANY_TASK || r.kind() == TokenKind.TASK);
        sound.add(tasks ? NO_TASK : NO_PROXY);
        sound.add(tasks ? NO_PROXY : NO_TASK);
    }

    /** What a firing can do with tokens on an edge out of a transition. */
    public List<OutRequirement> out(OutEdge edge) {
        Set<OutRequirement> sound = new LinkedHashSet<>(computed.out(edge.id()));
        if (namesTokens(edge.transition())) {
            sound.add(take(TokenKind.RELEVANT));
        }
        for (TokenType kind : EnumSet.of(TokenType.PROXY, TokenType.TASK)) {
            if (plan.inEdgesOf(edge.transition()).stream().anyMatch(e -> coming.comes(kind, e.place()))) {
                sound.add(take(kind(kind)));
            }
        }
        sound.add(take(TokenKind.ANY_TOKEN));
        sound.removeIf(r -> r.kind() == TokenKind.GENERIC
                || r.kind() == TokenKind.UNCONDITIONAL
                || edge.requirements().stream().anyMatch(there -> there.kind() == r.kind()));
        return List.copyOf(sound);
    }

    private static OutRequirement take(TokenKind kind) {
        return OutRequirement.of(Action.TAKE, OutRequirement.ALL, kind);
    }

    private static TokenKind kind(TokenType kind) {
        return kind == TokenType.PROXY ? TokenKind.ANY_PROXY : TokenKind.ANY_TASK;
    }
}
