package org.sami.spn.legacy;

import java.util.List;
import java.util.Optional;
import org.sami.spn.legacy.LegacyPlan.Kind;
import org.sami.spn.legacy.LegacyPlan.Move;
import org.sami.spn.legacy.LegacyPlan.Quantity;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;

/**
 * Makes requirements of this language of the export's. Where this language has no such combination it is replaced by what the
 * earlier system did with it, with a warning; an edge without any becomes unconditional.
 */
final class RequirementConverter {
    private final Findings findings;
    private final Counts.Tally explained;
    private final Counts.Tally added;

    /**
     * @param explained counts what did not arrive
     * @param added counts what was written although the export does not have it
     */
    RequirementConverter(Findings findings, Counts.Tally explained, Counts.Tally added) {
        this.findings = findings;
        this.explained = explained;
        this.added = added;
    }

    List<InRequirement> in(LegacyPlan.Edge edge) {
        List<InRequirement> requirements =
                edge.requirements().stream().map(r -> in(edge, r)).toList();
        if (requirements.isEmpty()) {
            tellUnconditional(edge, CountedKind.IN_REQUIREMENTS);
            return List.of(InRequirement.unconditional());
        }
        return requirements;
    }

    List<OutRequirement> out(LegacyPlan.Edge edge) {
        List<OutRequirement> requirements = edge.requirements().stream()
                .map(r -> out(edge, r))
                .flatMap(Optional::stream)
                .toList();
        if (requirements.isEmpty()) {
            tellUnconditional(edge, CountedKind.OUT_REQUIREMENTS);
            return List.of(OutRequirement.unconditional());
        }
        return requirements;
    }

    private void tellUnconditional(LegacyPlan.Edge edge, CountedKind kind) {
        added.add(kind, 1);
        if (edge.mode() != LegacyPlan.DrawingMode.MOCKUP) {
            findings.warning(
                    LegacyCodes.NO_REQUIREMENT,
                    edge.pointer(),
                    "The edge " + edge.key() + " from " + edge.from() + " to " + edge.to()
                            + " has no requirement; it is written as unconditional",
                    edge.key());
        }
    }

    private void warn(LegacyPlan.Edge edge, LegacyPlan.Requirement r, String message) {
        findings.warning(LegacyCodes.REQUIREMENT, r.pointer(), "Edge " + edge.key() + ": " + message, edge.key());
    }

    private InRequirement in(LegacyPlan.Edge edge, LegacyPlan.Requirement r) {
        if (r.kind() == Kind.NONE) {
            return InRequirement.unconditional();
        }
        if (r.kind() == Kind.SUB_MISSION) {
            warn(edge, r, "sub-mission tokens are no condition; it is written as unconditional");
            return InRequirement.unconditional();
        }
        if (r.match().isEmpty()) {
            warn(edge, r, "a requirement without a match is no condition; it is written as unconditional");
            return InRequirement.unconditional();
        }
        TokenKind kind = kind(r.kind());
        return switch (r.match().get()) {
            case NONE -> zero(kind, r);
            case ALL -> all(edge, kind, r);
            case LESS_THAN -> lessThan(edge, kind, r);
            case AT_LEAST -> atLeast(edge, kind, r);
            case NUMBER ->
                r.quantity() < 1 ? zero(kind, r) : new InRequirement(kind, Match.EXACTLY, r.quantity(), task(r));
        };
    }

    private static InRequirement zero(TokenKind kind, LegacyPlan.Requirement r) {
        return new InRequirement(kind, Match.ZERO, 0, task(r));
    }

    private InRequirement all(LegacyPlan.Edge edge, TokenKind kind, LegacyPlan.Requirement r) {
        if (kind == TokenKind.RELEVANT) {
            return InRequirement.allRelevant();
        }
        warn(edge, r, "\"all\" is a condition on relevant tokens only; it is written as at least 1");
        return new InRequirement(kind, Match.AT_LEAST, 1, task(r));
    }

    private InRequirement lessThan(LegacyPlan.Edge edge, TokenKind kind, LegacyPlan.Requirement r) {
        if (r.quantity() < 1) {
            warn(edge, r, "less than " + r.quantity() + " can never hold; it is written as a number that no place has");
            return new InRequirement(kind, Match.EXACTLY, Integer.MAX_VALUE, task(r));
        }
        return new InRequirement(kind, Match.LESS_THAN, r.quantity(), task(r));
    }

    private InRequirement atLeast(LegacyPlan.Edge edge, TokenKind kind, LegacyPlan.Requirement r) {
        if (r.quantity() < 1) {
            warn(edge, r, "at least " + r.quantity() + " always holds; it is written as unconditional");
            return InRequirement.unconditional();
        }
        return new InRequirement(kind, Match.AT_LEAST, r.quantity(), task(r));
    }

    private Optional<OutRequirement> out(LegacyPlan.Edge edge, LegacyPlan.Requirement r) {
        if (r.kind() == Kind.NONE) {
            return Optional.of(OutRequirement.unconditional());
        }
        Action action = action(edge, r);
        TokenKind kind = kind(r.kind());
        int n = quantity(edge, r);
        if (n == 0) {
            warn(edge, r, "it moves 0 tokens, which is nothing; it is left out");
            explained.add(CountedKind.OUT_REQUIREMENTS, 1);
            return Optional.empty();
        }
        return Optional.of(new OutRequirement(kind, n, action, task(r)));
    }

    private int quantity(LegacyPlan.Edge edge, LegacyPlan.Requirement r) {
        Quantity match = r.match().orElse(Quantity.ALL);
        if (match == Quantity.ALL) {
            return OutRequirement.ALL;
        }
        if (match != Quantity.NUMBER) {
            warn(
                    edge,
                    r,
                    "an edge to a place moves a number of tokens, or all; it is written as "
                            + Math.max(0, r.quantity()));
        }
        return match == Quantity.NONE ? 0 : Math.max(0, r.quantity());
    }

    private Action action(LegacyPlan.Edge edge, LegacyPlan.Requirement r) {
        if (r.move().isEmpty()) {
            warn(edge, r, "it does not say what to do with the tokens; it is written as take");
        }
        return switch (r.move().orElse(Move.TAKE)) {
            case TAKE -> Action.TAKE;
            case CONSUME -> Action.CONSUME;
            case ADD -> Action.ADD;
        };
    }

    private static String task(LegacyPlan.Requirement r) {
        return r.kind() == Kind.SPECIFIC_TASK ? r.task() : "";
    }

    private static TokenKind kind(Kind kind) {
        return switch (kind) {
            case NONE -> TokenKind.UNCONDITIONAL;
            case GENERIC -> TokenKind.GENERIC;
            case ANY_PROXY -> TokenKind.ANY_PROXY;
            case ANY_TASK -> TokenKind.ANY_TASK;
            case ANY_TOKEN -> TokenKind.ANY_TOKEN;
            case RELEVANT -> TokenKind.RELEVANT;
            case SPECIFIC_TASK -> TokenKind.TASK;
            case SUB_MISSION -> TokenKind.SUB_MISSION_TOKENS;
        };
    }
}
