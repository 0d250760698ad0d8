package org.sami.crw.decision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToIntFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sami.crw.markup.MarkupReader;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** What a decision offers, in the order of the markup Sort, boats without it by their names, and with what the markup Default Selection selects. */
final class OfferedOptions {
    private static final String SORT = "Sort";
    private static final Comparator<OfferedOption> BY_NAME =
            Comparator.comparing(OfferedOption::label, NaturalOrder.INSTANCE);

    private OfferedOptions() {}

    /** By what is sorted. */
    enum Method {
        ALPHABETICAL,
        CHRONOLOGICAL
    }

    /** Which end comes first. */
    enum Order {
        INCREASING,
        DECREASING
    }

    /** What is selected when a decision opens. */
    enum Selection {
        ALL,
        NONE
    }

    /**
     * The options of a decision.
     *
     * @param joined the known boats, oldest first, for sorting by age
     * @param detailOf the details of a boat, without its name
     */
    static List<OfferedOption> of(
            Decision decision, MarkupReader markups, List<String> joined, UnaryOperator<String> detailOf) {
        Question question = decision.question();
        if (question instanceof Question.ChooseProxies choose) {
            List<OfferedOption> boats = new ArrayList<>();
            for (String boat : choose.proxies()) {
                boats.add(new OfferedOption(boats.size(), new ProxyValue(boat), boat, detailOf.apply(boat), false));
            }
            boats.sort(BY_NAME);
            List<OfferedOption> sorted =
                    sorted(boats, markups, choice -> age(((ProxyValue) choice.value()).proxy(), choice, joined));
            boolean all = DomainQuestion.of(decision.type())
                    .filter(DomainQuestion::simulatedAnswer)
                    .isPresent();
            return selected(sorted, all || isAllSelected(markups), choose.max());
        }
        if (question instanceof Question.ChooseOption choose) {
            List<OfferedOption> options = new ArrayList<>();
            for (Value option : choose.options()) {
                options.add(new OfferedOption(
                        options.size(), option, ValueWords.label(option), ValueWords.detail(option), false));
            }
            return selected(sorted(options, markups, OfferedOption::index), isAllSelected(markups), 1);
        }
        return List.of();
    }

    private static int age(String boat, OfferedOption choice, List<String> joined) {
        int known = joined.indexOf(boat);
        return known < 0 ? joined.size() + choice.index() : known;
    }

    /** Sorted as the markup says; without its order alphabetically from A, and chronologically the newest first (thesis 6.3.2). */
    private static List<OfferedOption> sorted(
            List<OfferedOption> choices, MarkupReader markups, ToIntFunction<OfferedOption> age) {
        Method method = markups.constant(SORT, "method", Method.class).orElse(null);
        if (method == null) {
            return choices;
        }
        Comparator<OfferedOption> by = method == Method.ALPHABETICAL ? BY_NAME : Comparator.comparingInt(age);
        Order order = markups.constant(SORT, "order", Order.class)
                .orElse(method == Method.ALPHABETICAL ? Order.INCREASING : Order.DECREASING);
        return choices.stream()
                .sorted(order == Order.INCREASING ? by : by.reversed())
                .toList();
    }

    private static boolean isAllSelected(MarkupReader markups) {
        return markups.constant("DefaultSelection", "selection", Selection.class)
                .filter(selection -> selection == Selection.ALL)
                .isPresent();
    }

    /** All that may be chosen are selected, from the top, where the markup says so. */
    private static List<OfferedOption> selected(List<OfferedOption> choices, boolean all, int max) {
        List<OfferedOption> result = new ArrayList<>();
        for (OfferedOption choice : choices) {
            result.add(new OfferedOption(
                    choice.index(), choice.value(), choice.label(), choice.detail(), all && result.size() < max));
        }
        return result;
    }

    /** An answer in words, with the labels of the options. */
    static String words(Answer answer, List<OfferedOption> choices) {
        if (answer instanceof Answer.YesNo yesNo) {
            return yesNo.yes() ? "yes" : "no";
        }
        if (answer instanceof Answer.Proxies chosen) {
            return String.join(", ", chosen.proxies());
        }
        if (answer instanceof Answer.Option option) {
            return choices.stream()
                    .filter(choice -> choice.index() == option.index())
                    .map(OfferedOption::label)
                    .findFirst()
                    .orElse("option " + (option.index() + 1));
        }
        if (answer instanceof Answer.Fields fields) {
            return fields.values().entrySet().stream()
                    .map(field -> field.getKey() + " = " + ValueWords.of(field.getValue()))
                    .collect(Collectors.joining(", "));
        }
        return "none of them";
    }
}
