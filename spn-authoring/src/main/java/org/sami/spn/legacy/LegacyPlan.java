package org.sami.spn.legacy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A plan of the export. Pointers are JSON pointers into it. */
record LegacyPlan(
        String pointer,
        String id,
        String name,
        Role role,
        List<Vertex> vertices,
        List<Edge> edges,
        List<String> reads,
        List<String> writes,
        List<Task> tasks,
        int danglingEdgeRefs) {
    private static final Pattern IN_A_PLAN = Pattern.compile("^/plans/(\\d+)(/|$)");

    LegacyPlan {
        vertices = List.copyOf(vertices);
        edges = List.copyOf(edges);
        reads = List.copyOf(reads);
        writes = List.copyOf(writes);
        tasks = List.copyOf(tasks);
    }

    List<Vertex> places() {
        return vertices.stream().filter(Vertex::place).toList();
    }

    List<Vertex> transitions() {
        return vertices.stream().filter(v -> !v.place()).toList();
    }

    boolean hasStart() {
        return vertices.stream().anyMatch(v -> v.place() && v.start());
    }

    /** What a plan is in the earlier system. */
    enum Role {
        /** A plan that is started by itself. */
        ROOT,
        /** The copy that a place runs. */
        INSTANCE,
        /** A plan outside the mission tree. */
        DETACHED
    }

    /** In which drawing mode an element was made. */
    enum DrawingMode {
        NOMINAL,
        RECOVERY,
        HIDDEN_RECOVERY,
        MOCKUP
    }

    /** On which side an event belongs, by its class. */
    enum Side {
        INPUT,
        OUTPUT,
        UNKNOWN
    }

    /** A task of a plan. */
    record Task(String pointer, String name, String className) {}

    /** Events and sub-missions of a vertex, and in what order it looks at its neighbours. */
    record Vertex(
            String pointer,
            String key,
            boolean place,
            String name,
            DrawingMode mode,
            double x,
            double y,
            boolean start,
            boolean end,
            boolean endsShared,
            List<String> outTransitions,
            List<String> inPlaces,
            List<String> outPlaces,
            List<Event> events,
            List<SubMission> subMissions,
            Optional<LegacyValue> mockup) {
        Vertex {
            outTransitions = List.copyOf(outTransitions);
            inPlaces = List.copyOf(inPlaces);
            outPlaces = List.copyOf(outPlaces);
            events = List.copyOf(events);
            subMissions = List.copyOf(subMissions);
        }

        String title() {
            return name.isBlank() ? key : key + " (" + name + ")";
        }
    }

    /**
     * An event.
     *
     * @param declared fields that its class declares
     */
    record Event(
            LegacyValue whole,
            String key,
            String className,
            Side side,
            List<String> declared,
            Map<String, LegacyValue> values,
            Map<String, String> reads,
            Map<String, String> writes,
            Map<String, Boolean> editable,
            List<Markup> markups) {
        String pointer() {
            return whole.pointer();
        }

        /** The class without its package. */
        String simpleName() {
            return LegacyPlan.simpleName(className);
        }
    }

    /** A markup with its chosen constants and its parameters. */
    record Markup(
            String pointer, String className, Map<String, LegacyValue> options, Map<String, LegacyValue> parameters) {}

    /**
     * A plan that a place runs.
     *
     * @param shared one instance for the whole parent mission
     * @param tasks the child's task for the parent's
     */
    record SubMission(String pointer, String plan, boolean shared, Map<String, String> tasks) {}

    /** An edge with its requirements; {@code in} leads from a place to a transition. */
    record Edge(
            String pointer,
            String key,
            boolean in,
            String from,
            String to,
            DrawingMode mode,
            List<Requirement> requirements,
            Optional<LegacyValue> mockup) {
        Edge {
            requirements = List.copyOf(requirements);
        }
    }

    /** Which tokens a requirement speaks of. */
    enum Kind {
        NONE,
        GENERIC,
        ANY_PROXY,
        ANY_TASK,
        ANY_TOKEN,
        RELEVANT,
        SPECIFIC_TASK,
        SUB_MISSION
    }

    /** How many tokens a requirement wants. */
    enum Quantity {
        NONE,
        LESS_THAN,
        AT_LEAST,
        ALL,
        NUMBER
    }

    /** What an out edge does with them. */
    enum Move {
        TAKE,
        CONSUME,
        ADD
    }

    /** A requirement as it stands; {@code match} and {@code move} may be unset. */
    record Requirement(
            String pointer, Kind kind, Optional<Quantity> match, int quantity, String task, Optional<Move> move) {}

    /** Which plan of the export a pointer leads into. */
    static Optional<Integer> indexIn(String pointer) {
        Matcher matcher = IN_A_PLAN.matcher(pointer);
        return matcher.find() ? Optional.of(Integer.valueOf(matcher.group(1))) : Optional.empty();
    }

    static String simpleName(String className) {
        return className.substring(className.lastIndexOf('.') + 1);
    }
}
