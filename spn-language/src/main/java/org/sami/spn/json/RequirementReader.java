package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;

/** Reads the requirements of edges and refuses combinations that mean nothing (R-IN-1, R-IN-2, R-OUT-1). */
final class RequirementReader {
    Optional<InRequirement> in(JsonObjectReader m) {
        Optional<TokenKind> kind = m.word("kind", TokenKind.class);
        Optional<Match> match = m.has("match") ? m.word("match", Match.class) : Optional.empty();
        boolean counted = m.has("n");
        int n = m.integer("n", 0);
        String task = m.text("task", "");
        m.done();
        if (kind.isEmpty() || (m.has("match") && match.isEmpty())) {
            return Optional.empty();
        }
        Optional<String> nonsense = inNonsense(kind.get(), match, counted, n, task);
        nonsense.ifPresent(message -> m.problem(Codes.REQUIREMENT, "", message));
        return nonsense.isPresent()
                ? Optional.empty()
                : Optional.of(new InRequirement(kind.get(), match.orElse(Match.ALL), n, task));
    }

    private static Optional<String> inNonsense(
            TokenKind kind, Optional<Match> match, boolean counted, int n, String task) {
        if (kind == TokenKind.SUB_MISSION_TOKENS) {
            return Optional.of("Sub-mission tokens stand on out edges only");
        }
        if (kind == TokenKind.UNCONDITIONAL) {
            return match.isPresent() || counted || !task.isEmpty()
                    ? Optional.of("An unconditional edge has no \"match\", \"n\" or \"task\"")
                    : Optional.empty();
        }
        if (match.isEmpty()) {
            return Optional.of("\"match\" is missing; it is one of: " + Words.all(Match.class));
        }
        if (match.get() == Match.ALL && kind != TokenKind.RELEVANT) {
            return Optional.of("Match \"all\" goes with relevant tokens only");
        }
        boolean needsNumber =
                match.get() == Match.LESS_THAN || match.get() == Match.AT_LEAST || match.get() == Match.EXACTLY;
        if (needsNumber != counted) {
            return Optional.of("\"n\" goes with less-than, at-least and exactly, and only with them");
        }
        if (needsNumber && n < 1) {
            return Optional.of("\"n\" is 1 or more; for none at all write \"match\": \"zero\"");
        }
        return taskNonsense(kind, task);
    }

    private static Optional<String> taskNonsense(TokenKind kind, String task) {
        return (kind == TokenKind.TASK) == task.isEmpty()
                ? Optional.of("\"task\" names a task or a task class with kind \"task\", and only there")
                : Optional.empty();
    }

    Optional<OutRequirement> out(JsonObjectReader m) {
        Optional<TokenKind> kind = m.word("kind", TokenKind.class);
        Optional<Action> action = m.has("action") ? m.word("action", Action.class) : Optional.empty();
        Optional<JsonNode> quantity = m.node("n");
        String task = m.text("task", "");
        m.done();
        if (kind.isEmpty() || (m.has("action") && action.isEmpty())) {
            return Optional.empty();
        }
        if (kind.get() == TokenKind.UNCONDITIONAL) {
            if (action.isPresent() || quantity.isPresent() || !task.isEmpty()) {
                m.problem(Codes.REQUIREMENT, "", "An unconditional edge has no \"action\", \"n\" or \"task\"");
                return Optional.empty();
            }
            return Optional.of(OutRequirement.unconditional());
        }
        int n = quantity.map(q -> quantity(q)).orElse(-2);
        Optional<String> nonsense = outNonsense(kind.get(), action, n, task);
        nonsense.ifPresent(message -> m.problem(Codes.REQUIREMENT, "", message));
        return nonsense.isPresent()
                ? Optional.empty()
                : Optional.of(new OutRequirement(kind.get(), n, action.orElse(Action.TAKE), task));
    }

    private static int quantity(JsonNode node) {
        if (node.isTextual() && node.textValue().equals("all")) {
            return OutRequirement.ALL;
        }
        return node.isIntegralNumber() && node.canConvertToInt() && node.intValue() > 0 ? node.intValue() : -2;
    }

    private static Optional<String> outNonsense(TokenKind kind, Optional<Action> action, int n, String task) {
        if (action.isEmpty()) {
            return Optional.of("\"action\" is missing; it is one of: " + Words.all(Action.class));
        }
        if (n < OutRequirement.ALL) {
            return Optional.of("\"n\" is missing or no quantity: write a number from 1, or \"all\"");
        }
        return taskNonsense(kind, task);
    }
}
