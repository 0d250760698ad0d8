package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Reads what {@link ProtocolEncoder} wrote. */
public final class ProtocolDecoder extends ValueDecoder {
    public ProtocolDecoder(byte[] bytes) {
        super(bytes);
    }

    public Token token() {
        return switch (tag()) {
            case PlacedToken.GENERIC -> Token.GENERIC;
            case PlacedToken.PROXY -> new Token.Proxy(text());
            case PlacedToken.TASK -> new Token.Task((TaskId) value());
            default -> throw new IllegalArgumentException("No kind of token");
        };
    }

    public List<Token> tokens() {
        List<Token> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add(token());
        }
        return result;
    }

    private List<TaskId> tasks() {
        List<TaskId> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add((TaskId) value());
        }
        return result;
    }

    public Occurrence occurrence() {
        return new Occurrence(text(), number(), number(), texts(), tasks(), values());
    }

    public Activation activation() {
        long id = number();
        long mission = number();
        long root = number();
        long visit = number();
        String plan = text();
        String place = text();
        String event = text();
        String type = text();
        Map<String, Value> fields = values();
        Map<TaskId, Map<String, Value>> taskValues = new LinkedHashMap<>();
        for (int i = size(); i > 0; i--) {
            TaskId task = (TaskId) value();
            taskValues.put(task, values());
        }
        List<Token> tokens = tokens();
        Map<TaskId, String> allocation = new LinkedHashMap<>();
        for (int i = size(); i > 0; i--) {
            TaskId task = (TaskId) value();
            allocation.put(task, text());
        }
        return new Activation(
                id,
                mission,
                root,
                visit,
                plan,
                place,
                event,
                type,
                fields,
                taskValues,
                tokens,
                allocation,
                markups(),
                Priority.valueOf(text()));
    }

    private List<MarkupSpec> markups() {
        List<MarkupSpec> result = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            result.add(new MarkupSpec(text(), values()));
        }
        return result;
    }

    public Decision decision() {
        return new Decision(
                number(),
                number(),
                number(),
                text(),
                text(),
                question(),
                flag() ? Optional.of(answer()) : Optional.empty(),
                flag() ? OptionalLong.of(number()) : OptionalLong.empty(),
                Priority.valueOf(text()),
                markups());
    }

    private Question question() {
        return switch (tag()) {
            case 0 -> new Question.Approve();
            case 1 -> new Question.ChooseProxies(texts(), integer(), integer());
            case 2 -> new Question.ChooseOption(valueList());
            default -> new Question.FillIn(items());
        };
    }

    private List<Question.Item> items() {
        List<Question.Item> items = new ArrayList<>();
        for (int i = size(); i > 0; i--) {
            items.add(new Question.Item(text(), type(), text(), optional(), flag(), text()));
        }
        return items;
    }

    private ValueType type() {
        return switch (tag()) {
            case 0 -> ValueType.Simple.valueOf(text());
            case 1 -> new ValueType.Named(text());
            case 2 -> new ValueType.ListOf(type());
            default -> new ValueType.MapOf(type(), type());
        };
    }

    private Answer answer() {
        return switch (tag()) {
            case 0 -> new Answer.YesNo(flag());
            case 1 -> new Answer.Proxies(texts());
            case 2 -> new Answer.Option(integer());
            case 3 -> new Answer.Rejected();
            default -> new Answer.Fields(values());
        };
    }
}
