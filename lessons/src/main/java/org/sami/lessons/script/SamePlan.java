package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.vocabulary.Reserved;

/**
 * Compares plans but for positions and ids: what joins what, names, events, fields, markups, requirements, tasks, and variables whatever their
 * names. What plans say about themselves, notes, frames and test cases are not looked at.
 */
public final class SamePlan {
    private static final int MOST_NAMED = 4;

    private final Project project;
    private final Project other;
    private final Map<String, String> names = new LinkedHashMap<>();
    private final Map<String, String> otherNames = new LinkedHashMap<>();

    private SamePlan(Project project, Project other) {
        this.project = project;
        this.other = other;
    }

    /**
     * What differs between two projects, in words for the author of a lesson; empty where nothing does. Plans of the same id are compared, or,
     * where the ids differ, those of the same index.
     *
     * @param project the project that is, in the words "only here"
     * @param other the project that it should be
     */
    public static Optional<String> difference(Project project, Project other) {
        return new SamePlan(project, other).difference();
    }

    private Optional<String> difference() {
        if (project.plans().size() != other.plans().size()) {
            return Optional.of("It has " + project.plans().size() + " plans and not "
                    + other.plans().size());
        }
        List<String> ids = project.plans().stream().map(Plan::id).toList();
        List<String> otherIds = other.plans().stream().map(Plan::id).toList();
        boolean byId = Set.copyOf(ids).equals(Set.copyOf(otherIds));
        for (int i = 0; i < ids.size(); i++) {
            names.put(ids.get(i), byId ? ids.get(i) : "plan " + i);
            otherNames.put(otherIds.get(i), byId ? otherIds.get(i) : "plan " + i);
        }
        for (int i = 0; i < ids.size(); i++) {
            Plan plan = project.plans().get(i);
            Plan counterpart =
                    byId ? other.plan(plan.id()).orElseThrow() : other.plans().get(i);
            Optional<String> difference = difference(plan, counterpart);
            if (difference.isPresent()) {
                return difference.map(text -> "The plan \"" + plan.title() + "\": " + text);
            }
        }
        return Optional.empty();
    }

    private Optional<String> difference(Plan plan, Plan counterpart) {
        Map<String, ElementText> texts = ElementText.ofVertices(plan, names);
        Map<String, ElementText> otherTexts = ElementText.ofVertices(counterpart, otherNames);
        return unlike(words(texts), words(otherTexts))
                .or(() -> unlike(edges(plan, texts), edges(counterpart, otherTexts)))
                .or(() -> unlike(declared(project, plan), declared(other, counterpart)))
                .or(() -> unlike(tasks(plan), tasks(counterpart)))
                .or(() -> {
                    Map<String, String> mine = declarations(project, plan);
                    Map<String, String> others = declarations(other, counterpart);
                    NetMatch match = new NetMatch(
                            plan, counterpart, texts, otherTexts, (a, b) -> sameVariable(a, b, mine, others));
                    return match.found().isPresent()
                            ? Optional.empty()
                            : Optional.of(
                                    "it has the same elements, but joined otherwise, or with variables otherwise");
                });
    }

    private static boolean sameVariable(String a, String b, Map<String, String> mine, Map<String, String> others) {
        boolean reserved = a.equals(Reserved.TASK_VARIABLE) || b.equals(Reserved.TASK_VARIABLE);
        return reserved ? a.equals(b) : mine.getOrDefault(a, "").equals(others.getOrDefault(b, ""));
    }

    /** What each variable is that a plan sees, by name. */
    private static Map<String, String> declarations(Project project, Plan plan) {
        Map<String, String> declared = new TreeMap<>();
        project.globals().forEach(v -> declared.put(v.name(), "of the project: " + words(v)));
        plan.reads().forEach(name -> declared.merge(name, "read", (a, b) -> a + ", read"));
        plan.variables().forEach(v -> declared.put(v.name(), words(v)));
        return declared;
    }

    private static String words(VariableSpec variable) {
        return variable.type() + " " + variable.initial().map(Object::toString).orElse("");
    }

    private static List<String> declared(Project project, Plan plan) {
        return declarations(project, plan).values().stream()
                .map(v -> "a variable " + v)
                .toList();
    }

    private static List<String> tasks(Plan plan) {
        return plan.tasks().stream()
                .map(t -> "task " + t.name() + " of " + t.taskClass() + " " + new TreeMap<>(t.fields()))
                .toList();
    }

    private static List<String> words(Map<String, ElementText> texts) {
        return texts.values().stream().map(ElementText::words).toList();
    }

    private static List<String> edges(Plan plan, Map<String, ElementText> texts) {
        List<String> edges = new ArrayList<>();
        NetMatch.edges(plan).forEach((ends, text) -> {
            String[] end = ends.split(" > ", 2);
            edges.add("edge " + name(end[0], texts) + " > " + name(end[1], texts) + " " + text);
        });
        return edges;
    }

    private static String name(String vertex, Map<String, ElementText> texts) {
        ElementText text = texts.get(vertex);
        return text == null
                ? vertex
                : text.words()
                        .lines()
                        .findFirst()
                        .orElse(vertex)
                        .replaceAll("(NOMINAL|RECOVERY|EACH|ALL)", "")
                        .strip();
    }

    private static Optional<String> unlike(List<String> mine, List<String> others) {
        List<String> here = without(mine, others);
        List<String> there = without(others, mine);
        if (here.isEmpty() && there.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of((here.isEmpty() ? "" : "only here " + some(here))
                + (here.isEmpty() || there.isEmpty() ? "" : "; ")
                + (there.isEmpty() ? "" : "only there " + some(there)));
    }

    private static List<String> without(List<String> all, List<String> some) {
        List<String> left = new ArrayList<>(all);
        some.forEach(left::remove);
        return left;
    }

    private static String some(List<String> texts) {
        return texts.stream()
                        .limit(MOST_NAMED)
                        .map(t -> t.replaceAll("\\s+", " "))
                        .collect(Collectors.joining(", "))
                + (texts.size() > MOST_NAMED ? ", …" : "");
    }
}
