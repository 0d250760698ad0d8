package org.sami.crw.handler;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * For each event of the vocabulary the effect by which one sees that it works, and the scene that shows it with real parts. To add an
 * event: {@code shows} it in the cases that it belongs to; a new class of cases is a line of {@link #CASES}.
 */
final class EventCatalogue {
    /** Where an effect is seen. */
    enum Seen {
        /** A boat moves, stops or changes. */
        ON_A_BOAT,
        /** The operator is asked. */
        AS_A_DECISION,
        /** Tokens move, or the mission ends. */
        IN_THE_MARKING,
        /** A message or a record. */
        IN_A_REPORT
    }

    /** A scene that fails where the effect does not happen. */
    interface Check {
        void run() throws Exception;
    }

    /** One event's row. */
    record Row(String event, Seen seen, String effect, Check check) {}

    private static final List<Consumer<EventCatalogue>> CASES = List.of(
            MotionEventCases::add,
            AbortEventCases::add,
            ServiceEventCases::add,
            PlanningEventCases::add,
            NewsEventCases::add,
            SurroundingsEventCases::add,
            OperatorEventCases::add,
            MissionEventCases::add,
            TaskEventCases::add,
            FleetEventCases::add);

    private final Map<String, Row> rows = new LinkedHashMap<>();

    /** The whole catalogue. */
    static EventCatalogue whole() {
        EventCatalogue catalogue = new EventCatalogue();
        CASES.forEach(cases -> cases.accept(catalogue));
        return catalogue;
    }

    /** Adds an event; one that has a row already, or that no vocabulary declares, is a mistake. */
    EventCatalogue shows(String event, Seen seen, String effect, Check check) {
        if (!TestWorld.VOCABULARY.events().containsKey(event)) {
            throw new IllegalArgumentException("No event is called " + event);
        }
        if (rows.put(event, new Row(event, seen, effect, check)) != null) {
            throw new IllegalArgumentException(event + " is in the catalogue twice");
        }
        return this;
    }

    /** The rows by event. */
    Map<String, Row> rows() {
        return rows;
    }
}
