package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;

/** The requirements of an edge from a transition to a place: what a firing does with tokens. */
final class OutRequirementRows extends RequirementRows<OutRequirement> {
    private final transient OutEdge edge;

    OutRequirementRows(DreammContext context, Plan plan, OutEdge edge) {
        super(context, plan, edge.id(), edge.requirements());
        this.edge = edge;
        fill(
                "When the transition fires",
                OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC),
                "Take 1 Generic",
                edge.locked());
    }

    @Override
    void quantity(JPanel panel, OutRequirement r, int at) {
        choice(
                panel,
                combo(
                        allowed(Stream.of(Action.values()), ProfileIds::of),
                        Optional.of(r.action()),
                        OutRequirementRows::words,
                        a -> put(at, new OutRequirement(r.kind(), r.n(), a, r.task()))),
                "inspector-action-" + at,
                "What becomes of the tokens: taken along, consumed, or added as copies");
        choice(
                panel,
                combo(
                        allowed(Stream.of(true, false), ProfileIds::quantity),
                        Optional.of(r.takesAll()),
                        all -> all ? "All" : "n",
                        all -> put(
                                at,
                                new OutRequirement(
                                        r.kind(), all ? OutRequirement.ALL : first(r), r.action(), r.task()))),
                "inspector-quantity-" + at,
                "All tokens, or so many");
        if (!r.takesAll()) {
            number(panel, r.n(), at, n -> put(at, new OutRequirement(r.kind(), n, r.action(), r.task())));
        }
    }

    /** The number to begin with: one token, but two where one is the implied requirement, which has no row. */
    private static int first(OutRequirement r) {
        return r.action() == Action.TAKE && r.kind() == TokenKind.GENERIC ? 2 : 1;
    }

    private static String words(Action action) {
        return switch (action) {
            case TAKE -> "Take";
            case CONSUME -> "Consume";
            case ADD -> "Add";
        };
    }

    @Override
    HelpTopic topic(HelpTopics topics, OutRequirement r) {
        return topics.requirement(r);
    }

    @Override
    TokenKind kind(OutRequirement r) {
        return r.kind();
    }

    @Override
    String task(OutRequirement r) {
        return r.task();
    }

    @Override
    OutRequirement ofKind(OutRequirement r, TokenKind kind) {
        return kind == TokenKind.UNCONDITIONAL
                ? OutRequirement.unconditional()
                : new OutRequirement(kind, r.n(), r.action(), firstTask(kind));
    }

    @Override
    OutRequirement ofTask(OutRequirement r, String task) {
        return new OutRequirement(r.kind(), r.n(), r.action(), task);
    }

    @Override
    List<OutRequirement> sound() {
        return requirements.out(edge);
    }

    @Override
    boolean namesTokens() {
        return requirements.namesTokens(edge.transition());
    }

    @Override
    String said(OutRequirement r) {
        return RequirementWords.of(r);
    }

    @Override
    String quantityId(OutRequirement r) {
        return ProfileIds.of(r.action());
    }

    @Override
    OutRequirement fresh() {
        return OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_PROXY);
    }

    @Override
    OutRequirement moreThanImplied() {
        return OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.GENERIC);
    }

    @Override
    Edit edit(String plan, String edge, List<OutRequirement> requirements) {
        return new EdgeEdit.SetOutRequirements(plan, edge, requirements);
    }

    @Override
    List<TokenKind> kinds() {
        return List.of(TokenKind.values());
    }

    @Override
    String profileId(TokenKind kind) {
        return ProfileIds.out(kind);
    }

    @Override
    String unconditional() {
        return "Enter With Nobody";
    }
}
