package org.sami.spn.json;

import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;

/** On which side an event with a role stands, and which fields the engine reads from it by fixed names. */
final class RoleRules {
    private RoleRules() {}

    /** What is wrong with an event's role, empty where nothing is. */
    static Optional<String> check(EventType event) {
        EventRole role = event.role();
        if (role == EventRole.NONE) {
            return Optional.empty();
        }
        if (event.direction() != direction(role)) {
            return Optional.of("the role " + Words.of(role) + " is for " + Words.of(direction(role)) + " events");
        }
        for (Map.Entry<String, ValueType> field : fields(role).entrySet()) {
            Optional<ValueType> type = event.field(field.getKey()).map(FieldType::type);
            if (!type.equals(Optional.of(field.getValue()))) {
                return Optional.of("the role " + Words.of(role) + " needs the field " + field.getKey() + " of type "
                        + TypeNames.of(field.getValue()));
            }
        }
        return Optional.empty();
    }

    private static Direction direction(EventRole role) {
        return switch (role) {
            case TIMER,
                    PROXY_TIMER,
                    GET_ALL_TOKENS,
                    GENERAL_INTERRUPT,
                    PROXY_INTERRUPT,
                    ABORT_MISSION,
                    COMPLETE_MISSION,
                    RETURN_VALUE,
                    GENERATE_TASKS,
                    APPLY_ALLOCATION -> Direction.OUTPUT;
            default -> Direction.INPUT;
        };
    }

    private static Map<String, ValueType> fields(EventRole role) {
        return switch (role) {
            case TIMER, PROXY_TIMER -> Map.of(Reserved.DURATION, ValueType.Simple.DURATION);
            case INTERRUPT, GENERAL_INTERRUPT, PROXY_INTERRUPT ->
                Map.of(Reserved.INTERRUPT_NAME, ValueType.Simple.TEXT);
            case RETURN_VALUE, CHECK_RETURN -> Map.of(Reserved.VALUE, ValueType.Simple.TEXT);
            case APPLY_ALLOCATION ->
                Map.of(Reserved.TASKS, new ValueType.MapOf(ValueType.Simple.TASK, ValueType.Simple.PROXY));
            case GENERATE_TASKS -> Map.of(Reserved.TASK_CLASS, ValueType.Simple.TEXT);
            default -> Map.of();
        };
    }
}
