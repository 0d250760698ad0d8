package org.sami.crw.sim.legacy;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.spn.vocabulary.Vocabulary;

/** What the simulated operator is told for trial runs: texts of a boat that plans ask for at their start. */
final class TrialAnswers {
    private TrialAnswers() {}

    /**
     * Answers for a boat.
     *
     * @param name what it is called
     * @param server where it is connected to
     */
    static AnswersFile of(String name, String server, Vocabulary vocabulary) {
        ObjectNode file = JsonNodeFactory.instance.objectNode();
        file.put("format", "crw-answers").put("version", 1);
        ArrayNode rules = file.putArray("rules");
        start(rules, "name", name);
        start(rules, "server", server);
        start(rules, "color", "#ffffff");
        start(rules, "imageStorageDirectory", "");
        return AnswersFileReader.read(file.toString(), vocabulary).orThrow();
    }

    private static void start(ArrayNode rules, String field, String value) {
        ObjectNode rule = rules.addObject();
        rule.put("event", "start:" + field);
        rule.putObject("answer").put("value", value);
    }
}
