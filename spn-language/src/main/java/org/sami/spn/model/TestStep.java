package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/**
 * One step of a saved test case: something that is done to the mission, or something that is then expected of it. Steps
 * speak of the ids of the plan; where an event has several open activations, the oldest is meant.
 */
public sealed interface TestStep {
    /**
     * The operator answers the open decision of an output event.
     *
     * @param event id of the output event; empty text for the values asked when the mission starts
     */
    record Answer(String event, Reply reply) implements TestStep {
        public Answer {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(reply, "reply");
        }
    }

    /**
     * An input event arrives.
     *
     * @param type name of the input event type
     * @param answers id of the output event whose open activation it answers; empty text for news
     * @param tasks names of the mission's tasks that it names
     */
    record Occur(String type, String answers, List<String> proxies, List<String> tasks, Map<String, Value> values)
            implements TestStep {
        public Occur {
            Objects.requireNonNull(type, "type");
            Objects.requireNonNull(answers, "answers");
            proxies = List.copyOf(proxies);
            tasks = List.copyOf(tasks);
            values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
        }
    }

    /** A named interrupt of the plan or of one of its running sub-missions is pressed, for the given proxies or in general. */
    record Press(String interrupt, List<String> proxies) implements TestStep {
        public Press {
            Objects.requireNonNull(interrupt, "interrupt");
            proxies = List.copyOf(proxies);
        }
    }

    /** A robot becomes known while the mission runs. */
    record Join(String proxy) implements TestStep {
        public Join {
            Objects.requireNonNull(proxy, "proxy");
        }
    }

    /** The operator drops a robot from the mission. */
    record Drop(String proxy) implements TestStep {
        public Drop {
            Objects.requireNonNull(proxy, "proxy");
        }
    }

    /** Time passes; timers that are due run down. */
    record Advance(long millis) implements TestStep {
        public Advance {
            if (millis < 0) {
                throw new IllegalArgumentException("Time does not go back: " + millis);
            }
        }
    }

    /** Exactly these tokens stand in a place: so many generic ones, one per proxy, and one per task of the mission. */
    record ExpectTokens(String place, int generic, List<String> proxies, List<String> tasks) implements TestStep {
        public ExpectTokens {
            Objects.requireNonNull(place, "place");
            proxies = List.copyOf(proxies);
            tasks = List.copyOf(tasks);
            if (generic < 0) {
                throw new IllegalArgumentException("A number of tokens is not negative: " + generic);
            }
        }
    }

    /** The mission has ended by entering an end place. */
    record ExpectEnded() implements TestStep {}

    /** What an operator answers. */
    sealed interface Reply {
        /** Yes or no. */
        record YesNo(boolean yes) implements Reply {}

        /** The chosen proxies. */
        record Proxies(List<String> proxies) implements Reply {
            public Proxies {
                proxies = List.copyOf(proxies);
            }
        }

        /** The index of the chosen option, from 0. */
        record Option(int index) implements Reply {}

        /** None of the options. */
        record Rejected() implements Reply {}

        /** Values by the name of a field, {@code eventId.field} or the name of a variable. */
        record Values(Map<String, Value> values) implements Reply {
            public Values {
                values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
            }
        }
    }
}
