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
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;

/** The requirements of an edge from a place to a transition: what the transition waits for. */
final class InRequirementRows extends RequirementRows<InRequirement> {
    private final transient InEdge edge;

    InRequirementRows(DreammContext context, Plan plan, InEdge edge) {
        super(context, plan, edge.id(), edge.requirements());
        this.edge = edge;
        fill(
                "The transition waits until here is",
                InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1),
                "≥ 1 Generic",
                edge.locked());
    }

    @Override
    void quantity(JPanel panel, InRequirement r, int at) {
        List<Match> matches = allowed(
                Stream.of(Match.values()).filter(m -> m != Match.ALL || r.kind() == TokenKind.RELEVANT),
                ProfileIds::of);
        choice(
                panel,
                combo(
                        matches,
                        Optional.of(r.match()),
                        InRequirementRows::words,
                        m -> put(at, new InRequirement(r.kind(), m, first(r, m), r.task()))),
                "inspector-match-" + at,
                "How many");
        if (counted(r.match())) {
            number(panel, r.n(), at, n -> put(at, new InRequirement(r.kind(), r.match(), n, r.task())));
        }
    }

    /** The number to begin with: that of before or one, but two where one is the implied requirement, which has no row. */
    private static int first(InRequirement r, Match match) {
        boolean impliedByOne = match == Match.AT_LEAST && r.kind() == TokenKind.GENERIC;
        return counted(match) ? Math.max(impliedByOne ? 2 : 1, r.n()) : 0;
    }

    private static boolean counted(Match match) {
        return match == Match.LESS_THAN || match == Match.AT_LEAST || match == Match.EXACTLY;
    }

    private static String words(Match match) {
        return switch (match) {
            case ZERO -> "No";
            case LESS_THAN -> "<";
            case AT_LEAST -> "≥";
            case EXACTLY -> "=";
            case ALL -> "All";
        };
    }

    @Override
    HelpTopic topic(HelpTopics topics, InRequirement r) {
        return topics.requirement(r);
    }

    @Override
    TokenKind kind(InRequirement r) {
        return r.kind();
    }

    @Override
    String task(InRequirement r) {
        return r.task();
    }

    @Override
    InRequirement ofKind(InRequirement r, TokenKind kind) {
        if (kind == TokenKind.UNCONDITIONAL) {
            return InRequirement.unconditional();
        }
        Match match = r.match() == Match.ALL && kind != TokenKind.RELEVANT ? Match.AT_LEAST : r.match();
        return new InRequirement(kind, match, counted(match) ? Math.max(1, r.n()) : 0, firstTask(kind));
    }

    @Override
    InRequirement ofTask(InRequirement r, String task) {
        return new InRequirement(r.kind(), r.match(), r.n(), task);
    }

    @Override
    List<InRequirement> sound() {
        return requirements.in(edge);
    }

    @Override
    boolean namesTokens() {
        return requirements.namesTokens(edge.transition());
    }

    @Override
    String said(InRequirement r) {
        return RequirementWords.of(r);
    }

    @Override
    String quantityId(InRequirement r) {
        return ProfileIds.of(r.match());
    }

    @Override
    InRequirement fresh() {
        return InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 1);
    }

    @Override
    InRequirement moreThanImplied() {
        return InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 2);
    }

    @Override
    Edit edit(String plan, String edge, List<InRequirement> requirements) {
        return new EdgeEdit.SetInRequirements(plan, edge, requirements);
    }

    @Override
    List<TokenKind> kinds() {
        return Stream.of(TokenKind.values())
                .filter(k -> k != TokenKind.SUB_MISSION_TOKENS)
                .toList();
    }

    @Override
    String profileId(TokenKind kind) {
        return ProfileIds.in(kind);
    }

    @Override
    String unconditional() {
        return "No Condition";
    }
}
