package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;

/** Reads the hidden cases of a job. */
final class CaseReader {
    private static final int LOCATIONS = 3;
    private static final int MOST_LOCATIONS = 20;

    private final JobFormat format;

    CaseReader(JobFormat format) {
        this.format = format;
    }

    JobCase read(JsonObjectReader m) {
        String name = m.text("name");
        List<String> robots = robots(m);
        int locations = m.integer("locations", LOCATIONS);
        if (locations < 0 || locations > MOST_LOCATIONS) {
            m.problem(JobFormat.CODE, "locations", "There are 0 to " + MOST_LOCATIONS + " locations");
        }
        List<JobCase.Reaction> script = new ArrayList<>();
        List<JobCase.Happening> happenings = new ArrayList<>();
        for (JsonObjectReader element : m.objects("script")) {
            if (element.has("on")) {
                script.add(reaction(element));
            } else {
                happening(element).ifPresent(happenings::add);
            }
            element.done();
        }
        List<String> watch = new ArrayList<>();
        m.array("watch")
                .forEach(element ->
                        watch.add(format.event(element.node().asText(), Direction.OUTPUT, element.pointer())));
        List<JobCase.Expect> expect = new ArrayList<>();
        for (JsonObjectReader element : m.objects("expect")) {
            expect.add(new JobCase.Expect(wanted(element), element.text("else")));
            element.done();
        }
        m.done();
        return new JobCase(name, robots, locations, script, happenings, watch, expect);
    }

    private List<String> robots(JsonObjectReader m) {
        if (m.node("robots").filter(JsonNode::isArray).isPresent()) {
            return m.texts("robots");
        }
        int count = m.integer("robots", 0);
        if (count < 0 || count > RobotNames.MOST) {
            m.problem(JobFormat.CODE, "robots", "There are 0 to " + RobotNames.MOST + " robots");
            return List.of();
        }
        return RobotNames.first(count);
    }

    private JobCase.Reaction reaction(JsonObjectReader m) {
        String on = format.event(m.text("on"), Direction.OUTPUT, m.at("on"));
        boolean isSilent = m.has("answer") && m.whole().get("answer").isNull();
        String answer = m.text("answer", "");
        if (!answer.isEmpty()) {
            answer = format.event(answer, Direction.INPUT, m.at("answer"));
            if (!answers(on).contains(answer)) {
                m.problem(
                        JobFormat.CODE,
                        "answer",
                        answer + " is no answer to " + on + "; those are " + String.join(", ", answers(on)));
            }
        }
        return new JobCase.Reaction(
                on,
                m.texts("robots"),
                numbers(m, "tasks"),
                m.has("time") ? OptionalInt.of(m.integer("time", 1)) : OptionalInt.empty(),
                m.has("after") ? OptionalLong.of(millis(m, "after")) : OptionalLong.empty(),
                isSilent,
                answer,
                values(m, answer.isEmpty() ? answers(on) : List.of(answer)),
                choice(m));
    }

    private List<String> answers(String on) {
        return format.vocabulary().event(on).map(EventType::answers).orElse(List.of());
    }

    private Map<String, JsonNode> values(JsonObjectReader m, List<String> events) {
        Map<String, JsonNode> values = new LinkedHashMap<>();
        m.map("values").forEach((name, element) -> {
            values.put(name, element.node());
            Optional<ValueType> type = events.stream()
                    .flatMap(event -> format.vocabulary().event(event).stream())
                    .flatMap(event -> event.field(name).stream())
                    .map(field -> field.type())
                    .findFirst();
            type.ifPresent(known -> {
                Reading<Value> read = ValueJson.read(
                        element.node(), known, format.vocabulary().types());
                read.findings().forEach(finding -> format.add(finding.within(element.pointer())));
            });
        });
        return values;
    }

    private Optional<JobCase.Choice> choice(JsonObjectReader m) {
        Optional<JsonNode> choice = m.node("choose");
        if (choice.isEmpty()) {
            return Optional.empty();
        } else if (choice.get().isArray()) {
            return Optional.of(new JobCase.Choice(m.texts("choose"), 1));
        }
        return Optional.of(new JobCase.Choice(List.of(), m.integer("choose", 1)));
    }

    private Optional<JobCase.Happening> happening(JsonObjectReader m) {
        long at = millis(m, "at");
        if (m.has("happens")) {
            String type = format.event(m.text("happens"), Direction.INPUT, m.at("happens"));
            JobCase.What news =
                    new JobCase.What.News(type, m.texts("robots"), numbers(m, "tasks"), values(m, List.of(type)));
            return Optional.of(new JobCase.Happening(at, news));
        } else if (m.has("press")) {
            return Optional.of(new JobCase.Happening(at, new JobCase.What.Press(m.text("press"), m.texts("robots"))));
        } else if (m.has("drop")) {
            return Optional.of(new JobCase.Happening(at, new JobCase.What.Drop(m.text("drop"))));
        } else if (m.has("join")) {
            return Optional.of(new JobCase.Happening(at, new JobCase.What.Join(m.text("join"))));
        }
        m.problem(JobFormat.CODE, "", "This says neither \"on\" nor what happens, press, drop or join");
        return Optional.empty();
    }

    private long millis(JsonObjectReader m, String member) {
        Optional<JsonNode> node = m.node(member);
        if (node.isEmpty()) {
            m.problem(JobFormat.CODE, "", "\"" + member + "\" is missing: a time such as \"5 s\"");
            return 0;
        }
        Reading<Value> read = ValueJson.read(
                node.get(), ValueType.Simple.DURATION, format.vocabulary().types());
        read.findings().forEach(finding -> format.add(finding.within(m.at(member))));
        return read.result().map(value -> ((DurationValue) value).millis()).orElse(0L);
    }

    private List<Integer> numbers(JsonObjectReader m, String member) {
        List<Integer> numbers = new ArrayList<>();
        for (JsonObjectReader.Element element : m.array(member)) {
            if (element.node().canConvertToInt() && element.node().isIntegralNumber()) {
                numbers.add(element.node().intValue());
            } else {
                format.problem(element.pointer(), "Tasks are named by their numbers, from 1");
            }
        }
        return numbers;
    }

    private JobCase.Wanted wanted(JsonObjectReader m) {
        if (m.has("ends")) {
            return new JobCase.Wanted.Ends(m.flag("ends"));
        }
        String event = format.event(m.text("event"), Direction.OUTPUT, m.at("event"));
        if (m.has("after-all")) {
            return new JobCase.Wanted.AfterAll(
                    event, format.event(m.text("after-all"), Direction.INPUT, m.at("after-all")));
        }
        return new JobCase.Wanted.Happens(
                event, m.texts("robots"), m.has("times") ? OptionalInt.of(m.integer("times", 1)) : OptionalInt.empty());
    }
}
