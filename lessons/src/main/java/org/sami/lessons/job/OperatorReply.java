package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What the operator of a hidden case answers: what the script says, else all robots, the first option, yes, values that fit.
 *
 * @param reaction what the script says of the question
 * @param values what he gives where nothing is said
 * @param robots the known robots in order
 */
record OperatorReply(
        Optional<JobCase.Reaction> reaction, WorldValues values, List<String> robots, Vocabulary vocabulary) {

    /**
     * The answer to a question; empty where there is none.
     *
     * @param decision what its output event asks; empty where the mission itself or the engine asks
     */
    Optional<Answer> to(Question question, Optional<DecisionType> decision) {
        String said = reaction.map(JobCase.Reaction::answer).orElse("");
        boolean rejects = !said.isEmpty()
                && decision.filter(type -> type.rejected().equals(said)).isPresent();
        Optional<JobCase.Choice> choice = reaction.flatMap(JobCase.Reaction::choose);
        if (question instanceof Question.Approve) {
            return Optional.of(new Answer.YesNo(!rejects));
        } else if (question instanceof Question.ChooseProxies choose) {
            return proxies(choose, choice);
        } else if (question instanceof Question.ChooseOption choose) {
            int option = choice.map(JobCase.Choice::option).orElse(1);
            return Optional.of(
                    rejects || choose.options().size() < option || option < 1
                            ? new Answer.Rejected()
                            : new Answer.Option(option - 1));
        }
        return fields((Question.FillIn) question);
    }

    private Optional<Answer> proxies(Question.ChooseProxies choose, Optional<JobCase.Choice> choice) {
        List<String> wanted = choice.map(JobCase.Choice::robots).orElse(robots);
        List<String> chosen = robots.stream()
                .filter(robot -> choose.proxies().contains(robot) && wanted.contains(robot))
                .limit(choose.max())
                .toList();
        return chosen.size() < choose.min() ? Optional.empty() : Optional.of(new Answer.Proxies(chosen));
    }

    /** The operator has values of his own: what an author proposes makes no difference. */
    private Optional<Answer> fields(Question.FillIn fillIn) {
        Map<String, Value> given = new LinkedHashMap<>();
        for (Question.Item item : fillIn.items()) {
            Optional<Value> value = item.editable()
                    ? scripted(item.key(), item.type())
                            .or(() -> values.of(item.type()))
                            .or(item::defaultValue)
                    : item.defaultValue();
            if (value.isEmpty()) {
                return Optional.empty();
            }
            given.put(item.key(), value.get());
        }
        return Optional.of(new Answer.Fields(given));
    }

    private Optional<Value> scripted(String key, ValueType type) {
        String field = key.substring(key.indexOf('.') + 1);
        Map<String, JsonNode> said = reaction.map(JobCase.Reaction::values).orElse(Map.of());
        return Optional.ofNullable(said.get(field))
                .flatMap(node -> ValueJson.read(node, type, vocabulary.types()).result());
    }
}
