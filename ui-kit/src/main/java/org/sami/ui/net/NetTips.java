package org.sami.ui.net;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.picture.net.NetMarking;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.drawing.VertexWords;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.Vocabulary;

/** The tooltip of an element, one line for each statement. */
final class NetTips {
    private static final int MOST_TOKENS = 12;

    private NetTips() {}

    /**
     * The lines of an element; none where the plan does not have it.
     *
     * @param tokenName what people call a token
     */
    static List<String> of(
            Plan plan, Vocabulary vocabulary, NetMarking marking, String id, Function<Token, String> tokenName) {
        List<String> lines = new ArrayList<>();
        ElementNames names = new ElementNames(plan, vocabulary);
        plan.place(id).ifPresent(place -> {
            lines.add(names.of(place));
            lines.addAll(VertexWords.of(place, vocabulary).events());
            tokens(marking, id, tokenName).ifPresent(lines::add);
        });
        plan.transition(id).ifPresent(transition -> {
            lines.add(names.of(transition));
            lines.addAll(VertexWords.of(transition, vocabulary).events());
        });
        plan.inEdges().stream().filter(edge -> edge.id().equals(id)).forEach(edge -> {
            lines.add("Requires");
            edge.requirements().stream()
                    .map((InRequirement requirement) -> RequirementWords.of(requirement))
                    .forEach(lines::add);
        });
        plan.outEdges().stream().filter(edge -> edge.id().equals(id)).forEach(edge -> {
            lines.add("On firing");
            edge.requirements().stream()
                    .map((OutRequirement requirement) -> RequirementWords.of(requirement))
                    .forEach(lines::add);
        });
        return lines;
    }

    private static Optional<String> tokens(NetMarking marking, String place, Function<Token, String> tokenName) {
        List<Token> tokens = marking.at(place);
        if (tokens.isEmpty()) {
            return marking.visitedByNobody().contains(place)
                    ? Optional.of("Entered by nobody, awake")
                    : Optional.empty();
        }
        List<String> names = tokens.stream().limit(MOST_TOKENS).map(tokenName).toList();
        String rest = tokens.size() > MOST_TOKENS ? " and " + (tokens.size() - MOST_TOKENS) + " more" : "";
        return Optional.of(
                tokens.size() + (tokens.size() == 1 ? " token: " : " tokens: ") + String.join(", ", names) + rest);
    }

    /** What people call a token, as far as it says so itself. */
    static String name(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? "task " + task.task().name() : "generic";
    }
}
