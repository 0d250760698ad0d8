package org.sami.crw.decision;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Decision;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reads an answers file (docs/answers-file.md). Every problem is a finding with its place in the file; a file with one is
 * not used at all. What can be known from the vocabulary is checked here, values of variables and of fields that a plan asks at its
 * start only when they are asked for.
 */
public final class AnswersFileReader {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();
    private static final String BYTE_ORDER_MARK = "\uFEFF";
    private static final String FORMAT = "crw-answers";
    private static final int VERSION = 1;
    private static final List<String> TOP = List.of("$schema", "format", "version", "rules");
    private static final List<String> RULE = List.of("event", "plan", "nth", "answer");

    private final Vocabulary vocabulary;
    private final List<Finding> findings = new ArrayList<>();

    private AnswersFileReader(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** Reads the text of a file. */
    public static Reading<AnswersFile> read(String text, Vocabulary vocabulary) {
        return new AnswersFileReader(vocabulary).read(text).locatedIn("", text);
    }

    private Reading<AnswersFile> read(String text) {
        try {
            JsonNode top = MAPPER.readTree(text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text);
            List<AnswerRule> rules = top == null || !top.isObject() ? noObject("") : rules(top);
            return new Reading<>(findings.isEmpty() ? Optional.of(new AnswersFile(rules)) : Optional.empty(), findings);
        } catch (JsonProcessingException e) {
            Finding syntax = Finding.error("E-SYNTAX", "", e.getOriginalMessage());
            JsonLocation at = e.getLocation();
            if (at != null && at.getLineNr() > 0 && at.getColumnNr() > 0) {
                syntax = syntax.at(new SourceLocation("", at.getLineNr(), at.getColumnNr()));
            }
            return new Reading<>(Optional.empty(), List.of(syntax));
        }
    }

    private List<AnswerRule> rules(JsonNode top) {
        refuseUnknown(top, "", TOP);
        if (!FORMAT.equals(top.path("format").asText())) {
            add(
                    "E-VERSION",
                    "/format",
                    "The format is \"" + FORMAT + "\", not " + AnswerForm.shown(top.path("format")));
        }
        if (!top.path("version").isInt() || top.path("version").intValue() != VERSION) {
            add(
                    "E-VERSION",
                    "/version",
                    "This program reads version " + VERSION + ", not " + AnswerForm.shown(top.path("version")));
        }
        JsonNode list = top.path("rules");
        if (!list.isArray()) {
            add("E-WRONG-TYPE", "/rules", "The rules are a list, not " + AnswerForm.shown(list));
            return List.of();
        }
        List<AnswerRule> rules = new ArrayList<>();
        for (int i = 0; i < list.size(); i++) {
            rule(list.get(i), "/rules/" + i).ifPresent(rules::add);
        }
        return rules;
    }

    private Optional<AnswerRule> rule(JsonNode node, String pointer) {
        if (!node.isObject()) {
            noObject(pointer);
            return Optional.empty();
        }
        int before = findings.size();
        refuseUnknown(node, pointer, RULE);
        String event = text(node, "event", pointer);
        boolean start = event.startsWith(AnswerRule.START);
        Optional<String> plan = node.has("plan") ? Optional.of(text(node, "plan", pointer)) : Optional.empty();
        OptionalInt nth = nth(node, pointer);
        JsonNode answer = node.path("answer");
        if (!answer.isObject()) {
            add("E-WRONG-TYPE", pointer + "/answer", "The answer is an object, not " + AnswerForm.shown(answer));
        } else if (start) {
            AnswerForm.checkStart(answer, pointer + "/answer", findings);
        } else if (!event.isEmpty()) {
            checkEvent(event, answer, pointer);
        }
        if (findings.size() > before) {
            return Optional.empty();
        }
        String named = start
                ? event.substring(AnswerRule.START.length())
                : vocabulary.event(event).map(EventType::name).orElse(event);
        return Optional.of(new AnswerRule(pointer, named, start, plan, nth, answer));
    }

    private void checkEvent(String event, JsonNode answer, String pointer) {
        if (event.startsWith(Decision.INTERRUPT)) {
            AnswerForm.checkInterrupt(answer, pointer + "/answer", findings);
            return;
        }
        if (event.startsWith(Decision.ABORTED)) {
            AnswerForm.checkYesNo(answer, pointer + "/answer", findings);
            return;
        }
        Optional<EventType> type = vocabulary.event(event);
        if (DomainQuestion.of(event).isPresent()) {
            AnswerForm.checkYesNo(answer, pointer + "/answer", findings);
            return;
        }
        if (type.isEmpty()) {
            String meant = Suggestions.meant(questions(), event);
            add("E-UNKNOWN-EVENT", pointer + "/event", "There is no event \"" + event + "\"" + meant);
            return;
        }
        Optional<DecisionType> decision = type.get().decision();
        if (decision.isEmpty()) {
            add("E-DECISION", pointer + "/event", "The event \"" + event + "\" asks the operator nothing");
            return;
        }
        AnswerForm.check(answer, pointer + "/answer", decision.get(), vocabulary, findings);
    }

    /** The names, and the other names, of the events that ask the operator something. */
    private List<String> questions() {
        return vocabulary.events().values().stream()
                .filter(type -> type.decision().isPresent())
                .flatMap(type -> Stream.concat(Stream.of(type.name()), type.aliases().stream()))
                .toList();
    }

    private OptionalInt nth(JsonNode node, String pointer) {
        if (!node.has("nth")) {
            return OptionalInt.empty();
        }
        if (!node.get("nth").isInt() || node.get("nth").intValue() < 1) {
            add(
                    "E-BAD-VALUE",
                    pointer + "/nth",
                    "\"nth\" counts from 1 and is not " + AnswerForm.shown(node.get("nth")));
            return OptionalInt.empty();
        }
        return OptionalInt.of(node.get("nth").intValue());
    }

    private String text(JsonNode node, String member, String pointer) {
        JsonNode value = node.path(member);
        if (!value.isTextual() || value.textValue().isBlank()) {
            add("E-WRONG-TYPE", pointer + "/" + member, "\"" + member + "\" is a text, not " + AnswerForm.shown(value));
            return "";
        }
        return value.textValue();
    }

    private void refuseUnknown(JsonNode node, String pointer, List<String> known) {
        node.fieldNames().forEachRemaining(name -> {
            if (!known.contains(name)) {
                add(
                        "E-UNKNOWN-MEMBER",
                        pointer + "/" + name,
                        "\"" + name + "\" is none of " + known + Suggestions.meant(known, name));
            }
        });
    }

    private List<AnswerRule> noObject(String pointer) {
        add("E-WRONG-TYPE", pointer, "An object is expected here");
        return List.of();
    }

    private void add(String code, String pointer, String message) {
        findings.add(Finding.error(code, pointer, message));
    }
}
