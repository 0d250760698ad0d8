package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;

/**
 * What the engine takes in and gives out as JSON. Inputs can be read back, exactly, for journals; effects are written for
 * reports. Values say their own type, so no vocabulary is needed.
 */
public final class ProtocolJson {
    private ProtocolJson() {}

    /** An input as an object whose member {@code input} says its kind. */
    public static JsonNode input(Input input) {
        return InputWriter.write(input);
    }

    /** An input as one line of text. */
    public static String inputText(Input input) {
        return input instanceof Input.Received received
                ? ReceivedText.write(received.occurrence())
                : JsonText.text(InputWriter.write(input));
    }

    /**
     * Reads an input.
     *
     * @throws UnreadableJsonException naming the place and what is wrong there
     */
    public static Input readInput(JsonNode node) throws UnreadableJsonException {
        Problems problems = new Problems();
        Optional<Input> input = new InputReader(problems).read(node);
        if (!problems.none()) {
            throw new UnreadableJsonException(problems.findings().get(0));
        }
        return input.orElseThrow();
    }

    /**
     * Reads an input from text.
     *
     * @throws UnreadableJsonException naming the place and what is wrong there
     */
    public static Input readInput(String text) throws UnreadableJsonException {
        Problems problems = new Problems();
        Optional<JsonNode> node = JsonText.parse(text, problems);
        if (node.isEmpty()) {
            throw new UnreadableJsonException(problems.findings().get(0));
        }
        return readInput(node.get());
    }

    /** An effect as an object whose member {@code effect} says its kind. */
    public static JsonNode effect(Effect effect) {
        return EffectWriter.write(effect);
    }

    /** An activation with its resolved values. */
    public static JsonNode activation(Activation activation) {
        return EffectWriter.activation(activation);
    }

    /** A decision with its question. */
    public static JsonNode decision(Decision decision) {
        return DecisionWriter.write(decision);
    }

    /** A token: {@code "generic"}, {@code {"proxy": id}} or {@code {"task": {...}}}. */
    public static JsonNode token(Token token) {
        return EffectWriter.token(token);
    }
}
