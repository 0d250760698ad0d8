package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/** Searches which vertex of a plan stands for which of another, and which variable for which. */
final class NetMatch {
    /** Plans of lessons need a few hundred; a search that needs more is given up, as two plans that differ. */
    private static final int MOST_TRIES = 200_000;

    private final Plan plan;
    private final Plan other;
    private final Map<String, ElementText> texts;
    private final Map<String, ElementText> otherTexts;
    private final Map<String, String> edges;
    private final Map<String, String> otherEdges;
    private final BiPredicate<String, String> sameVariable;
    private final Map<String, Integer> colours = new HashMap<>();
    private final Map<String, Integer> otherColours = new HashMap<>();
    private final List<String> order = new ArrayList<>();
    private final Map<String, String> to = new LinkedHashMap<>();
    private int tries;

    /**
     * A search.
     *
     * @param sameVariable whether a variable can stand for one of the other plan, by their declarations
     */
    NetMatch(
            Plan plan,
            Plan other,
            Map<String, ElementText> texts,
            Map<String, ElementText> otherTexts,
            BiPredicate<String, String> sameVariable) {
        this.plan = plan;
        this.other = other;
        this.texts = texts;
        this.otherTexts = otherTexts;
        this.sameVariable = sameVariable;
        this.edges = edges(plan);
        this.otherEdges = edges(other);
    }

    /** The texts of edges, by the ids of their ends. */
    static Map<String, String> edges(Plan plan) {
        Map<String, String> edges = new TreeMap<>();
        plan.inEdges().forEach(e -> edges.put(key(e.place(), e.transition()), ElementText.of(e)));
        plan.outEdges().forEach(e -> edges.put(key(e.transition(), e.place()), ElementText.of(e)));
        return edges;
    }

    private static String key(String from, String to) {
        return from + " > " + to;
    }

    /** For each vertex of the plan that of the other one; empty where the nets differ. */
    Optional<Map<String, String>> found() {
        if (texts.size() != otherTexts.size() || edges.size() != otherEdges.size()) {
            return Optional.empty();
        }
        colour();
        Map<Integer, Long> size =
                colours.values().stream().collect(Collectors.groupingBy(c -> c, Collectors.counting()));
        if (!size.equals(
                otherColours.values().stream().collect(Collectors.groupingBy(c -> c, Collectors.counting())))) {
            return Optional.empty();
        }
        order.addAll(texts.keySet());
        order.sort(Comparator.comparing(v -> size.get(colours.get(v))));
        return search(0, Map.of()) ? Optional.of(to) : Optional.empty();
    }

    /** Gives vertices of both plans numbers that differ where their texts or their neighbours' numbers differ. */
    private void colour() {
        Map<String, Integer> numbers = new HashMap<>();
        texts.forEach((v, text) -> colours.put(v, number(numbers, text.words())));
        otherTexts.forEach((v, text) -> otherColours.put(v, number(numbers, text.words())));
        for (int round = 0; round < texts.size() && round < 12; round++) {
            Map<String, Integer> next = new HashMap<>();
            Map<String, Integer> a = refined(plan, colours, edges, next);
            Map<String, Integer> b = refined(other, otherColours, otherEdges, next);
            colours.putAll(a);
            otherColours.putAll(b);
        }
    }

    private static Map<String, Integer> refined(
            Plan plan, Map<String, Integer> colours, Map<String, String> edges, Map<String, Integer> numbers) {
        Map<String, List<String>> around = new HashMap<>();
        plan.inEdges().forEach(e -> joined(e.place(), e.transition(), colours, edges, around));
        plan.outEdges().forEach(e -> joined(e.transition(), e.place(), colours, edges, around));
        Map<String, Integer> refined = new HashMap<>();
        colours.forEach((v, colour) -> refined.put(
                v,
                number(
                        numbers,
                        colour
                                + around.getOrDefault(v, List.of()).stream()
                                        .sorted()
                                        .toList()
                                        .toString())));
        return refined;
    }

    private static void joined(
            String from,
            String to,
            Map<String, Integer> colours,
            Map<String, String> edges,
            Map<String, List<String>> around) {
        String edge = edges.get(key(from, to));
        around.computeIfAbsent(from, v -> new ArrayList<>()).add("> " + edge + colours.get(to));
        around.computeIfAbsent(to, v -> new ArrayList<>()).add("< " + edge + colours.get(from));
    }

    private static int number(Map<String, Integer> numbers, String text) {
        return numbers.computeIfAbsent(text, t -> numbers.size());
    }

    private boolean search(int index, Map<String, String> variables) {
        if (index == order.size()) {
            return sameOrders();
        }
        String vertex = order.get(index);
        for (String candidate : otherTexts.keySet()) {
            if (to.containsValue(candidate)
                    || !Objects.equals(colours.get(vertex), otherColours.get(candidate))
                    || ++tries > MOST_TRIES
                    || !sameEdges(vertex, candidate)) {
                continue;
            }
            Optional<Map<String, String>> more = joined(variables, vertex, candidate);
            if (more.isPresent()) {
                to.put(vertex, candidate);
                if (search(index + 1, more.get())) {
                    return true;
                }
                to.remove(vertex);
            }
        }
        return false;
    }

    private boolean sameEdges(String vertex, String candidate) {
        for (Map.Entry<String, String> matched : to.entrySet()) {
            boolean same = Objects.equals(
                            edges.get(key(vertex, matched.getKey())),
                            otherEdges.get(key(candidate, matched.getValue())))
                    && Objects.equals(
                            edges.get(key(matched.getKey(), vertex)),
                            otherEdges.get(key(matched.getValue(), candidate)));
            if (!same) {
                return false;
            }
        }
        return true;
    }

    /** The variables that stand for each other with those of two vertices; empty where one would stand for two. */
    private Optional<Map<String, String>> joined(Map<String, String> variables, String vertex, String candidate) {
        List<String> mine = Objects.requireNonNull(texts.get(vertex)).variables();
        List<String> others = Objects.requireNonNull(otherTexts.get(candidate)).variables();
        Map<String, String> joined = new HashMap<>(variables);
        for (int i = 0; i < mine.size(); i++) {
            String before = joined.put(mine.get(i), others.get(i));
            if ((before != null && !before.equals(others.get(i))) || !sameVariable.test(mine.get(i), others.get(i))) {
                return Optional.empty();
            }
        }
        Set<String> distinct = new HashSet<>(joined.values());
        return distinct.size() == joined.size() ? Optional.of(joined) : Optional.empty();
    }

    private boolean sameOrders() {
        for (Place place : plan.places()) {
            List<String> mapped = place.transitionOrder().stream()
                    .map(t -> to.getOrDefault(t, t))
                    .toList();
            List<String> there = other.place(to.getOrDefault(place.id(), ""))
                    .map(Place::transitionOrder)
                    .orElse(List.of());
            if (!mapped.equals(there)) {
                return false;
            }
        }
        return true;
    }
}
