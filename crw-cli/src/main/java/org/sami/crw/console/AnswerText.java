package org.sami.crw.console;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.OfferedOption;
import org.sami.crw.sim.run.settings.ValueText;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;

/** Answers as people type them, and how they are asked for them. */
final class AnswerText {
    private static final int LONGEST = 140;

    private final Map<String, NamedType> types;

    AnswerText(Map<String, NamedType> types) {
        this.types = Objects.requireNonNull(types, "types");
    }

    /** How a decision can be answered, line by line. */
    List<String> form(DecisionPresentation asked) {
        Question question = asked.question();
        if (question instanceof Question.Approve) {
            return List.of("yes or no");
        }
        if (question instanceof Question.ChooseProxies choose
                && choose.proxies().isEmpty()) {
            return List.of("nobody is there to choose" + (choose.min() == 0 ? "; all stands for none" : ""));
        }
        if (question instanceof Question.ChooseProxies choose) {
            String count = choose.max() == Integer.MAX_VALUE
                            || choose.max() >= choose.proxies().size()
                    ? choose.min() + " or more"
                    : choose.min() == choose.max()
                            ? String.valueOf(choose.min())
                            : choose.min() + " to " + choose.max();
            return List.of(count + " of "
                    + asked.options().stream().map(AnswerText::named).collect(Collectors.joining(", ")) + ", or all");
        }
        if (question instanceof Question.ChooseOption) {
            List<String> lines = new ArrayList<>();
            for (OfferedOption option : asked.options()) {
                lines.add((lines.size() + 1) + "  " + shortened(named(option)));
            }
            lines.add("the number of an option, or none");
            return lines;
        }
        List<String> values = ((Question.FillIn) question)
                .items().stream()
                        .filter(Question.Item::editable)
                        .map(this::form)
                        .toList();
        return values.isEmpty() ? List.of("its number alone: it is done") : values;
    }

    private static String named(OfferedOption option) {
        return option.label() + (option.detail().isEmpty() ? "" : " (" + option.detail() + ")");
    }

    private String form(Question.Item item) {
        String unit = item.unit().isEmpty() ? "" : " in " + item.unit();
        String preset = item.defaultValue()
                .map(value -> ", else " + ValueJson.write(value, item.type(), types))
                .orElse("");
        return item.key() + "=VALUE  (" + TypeNames.of(item.type()) + ": " + ValueText.form(item.type()) + unit + preset
                + ")";
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 3) + "...";
    }

    /** Words that answer a question, for completion. */
    List<String> completions(DecisionPresentation asked) {
        Question question = asked.question();
        if (question instanceof Question.Approve) {
            return List.of("yes", "no");
        }
        if (question instanceof Question.ChooseProxies choose) {
            List<String> words = new ArrayList<>(List.of("all"));
            if (asked.decision().isInterruptChoice()) {
                words.add("none");
            }
            words.addAll(choose.proxies());
            return words;
        }
        if (question instanceof Question.ChooseOption choose) {
            List<String> words = new ArrayList<>(List.of("none"));
            for (int i = 1; i <= choose.options().size(); i++) {
                words.add(String.valueOf(i));
            }
            return words;
        }
        return ((Question.FillIn) question)
                .items().stream()
                        .filter(Question.Item::editable)
                        .map(item -> item.key() + "=")
                        .toList();
    }

    /**
     * Reads an answer.
     *
     * @throws ConsoleFault if the words are none
     */
    Answer read(DecisionPresentation asked, List<String> words) {
        Question question = asked.question();
        String first = words.isEmpty() ? "" : words.get(0);
        if (question instanceof Question.Approve && words.size() == 1) {
            switch (first) {
                case "yes", "y" -> {
                    return new Answer.YesNo(true);
                }
                case "no", "n" -> {
                    return new Answer.YesNo(false);
                }
                default -> throw fault(asked, first);
            }
        }
        if (asked.decision().isInterruptChoice() && words.equals(List.of("none"))) {
            return new Answer.Rejected();
        }
        if (question instanceof Question.ChooseProxies choose && !words.isEmpty()) {
            return new Answer.Proxies(first.equals("all") ? choose.proxies() : names(words));
        }
        if (question instanceof Question.ChooseOption && words.size() == 1) {
            return option(asked, first);
        }
        if (question instanceof Question.FillIn fillIn) {
            return fields(asked, fillIn, words);
        }
        throw fault(asked, String.join(" ", words));
    }

    private static List<String> names(List<String> words) {
        return words.stream()
                .flatMap(word -> List.of(word.split("[,;]")).stream())
                .filter(word -> !word.isEmpty())
                .toList();
    }

    private Answer option(DecisionPresentation asked, String word) {
        if (word.equals("none")) {
            return new Answer.Rejected();
        }
        for (int i = 0; i < asked.options().size(); i++) {
            if (word.equals(String.valueOf(i + 1))) {
                return asked.choosing(List.of(asked.options().get(i)));
            }
        }
        throw fault(asked, word);
    }

    private Answer fields(DecisionPresentation asked, Question.FillIn question, List<String> words) {
        List<Question.Item> items =
                question.items().stream().filter(Question.Item::editable).toList();
        Map<String, Value> values = new LinkedHashMap<>();
        items.forEach(item -> item.defaultValue().ifPresent(value -> values.put(item.key(), value)));
        for (String word : words) {
            int equals = word.indexOf('=');
            String key = equals < 0 ? "" : word.substring(0, equals);
            Optional<Question.Item> item = items.size() == 1
                            && !key.equals(items.get(0).key())
                    ? Optional.of(items.get(0)) // the only value needs no name
                    : items.stream().filter(one -> one.key().equals(key)).findFirst();
            if (item.isEmpty()) {
                throw fault(asked, word);
            }
            String text = item.get().key().equals(key) ? word.substring(equals + 1) : word;
            values.put(item.get().key(), value(item.get(), text));
        }
        return new Answer.Fields(values);
    }

    private Value value(Question.Item item, String text) {
        List<Finding> findings = new ArrayList<>();
        return ValueText.parse(text, item.type(), types, findings)
                .orElseThrow(() -> new ConsoleFault(item.key() + " cannot be '" + text + "': expected is "
                        + ValueText.form(item.type())
                        + (findings.isEmpty() ? "" : " (" + findings.get(0).message() + ")")));
    }

    private ConsoleFault fault(DecisionPresentation asked, String given) {
        List<String> form = form(asked);
        return new ConsoleFault((given.isEmpty() ? "an answer is missing" : "'" + given + "' is no answer here")
                + "; expected is "
                + String.join("; ", form.size() > 4 ? form.subList(form.size() - 1, form.size()) : form));
    }
}
