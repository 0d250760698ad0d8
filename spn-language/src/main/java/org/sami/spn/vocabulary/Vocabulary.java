package org.sami.spn.vocabulary;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.NamedType;

/**
 * Everything a domain declares: the words that its plans may use. Immutable; look-up is by name, then by alias.
 */
public final class Vocabulary {
    private final String domain;
    private final Map<String, NamedType> types = new LinkedHashMap<>();
    private final Map<String, EventType> events = new LinkedHashMap<>();
    private final Map<String, EventType> eventsByAlias = new LinkedHashMap<>();
    private final Map<String, MarkupType> markups = new LinkedHashMap<>();
    private final Map<String, MarkupType> markupsByAlias = new LinkedHashMap<>();
    private final Map<String, TaskClass> taskClasses = new LinkedHashMap<>();
    private final Optional<Geography> geography;
    private final Map<String, String> robotNames;
    private final List<String> combines;

    /** A vocabulary of a domain that says nothing of distances and of names of robots. */
    public Vocabulary(
            String domain,
            List<NamedType> types,
            List<EventType> events,
            List<MarkupType> markups,
            List<TaskClass> taskClasses) {
        this(domain, types, events, markups, taskClasses, Optional.empty(), Map.of(), List.of());
    }

    /** A vocabulary of a domain that combines no others. */
    public Vocabulary(
            String domain,
            List<NamedType> types,
            List<EventType> events,
            List<MarkupType> markups,
            List<TaskClass> taskClasses,
            Optional<Geography> geography,
            Map<String, String> robotNames) {
        this(domain, types, events, markups, taskClasses, geography, robotNames, List.of());
    }

    /** A vocabulary; the reader has checked before that names are unique and references resolve. */
    public Vocabulary(
            String domain,
            List<NamedType> types,
            List<EventType> events,
            List<MarkupType> markups,
            List<TaskClass> taskClasses,
            Optional<Geography> geography,
            Map<String, String> robotNames,
            List<String> combines) {
        this.combines = List.copyOf(combines);
        this.robotNames = Collections.unmodifiableMap(new LinkedHashMap<>(robotNames));
        this.geography = Objects.requireNonNull(geography, "geography");
        this.domain = Objects.requireNonNull(domain, "domain");
        types.forEach(t -> this.types.put(t.name(), t));
        for (EventType event : events) {
            this.events.put(event.name(), event);
            event.aliases().forEach(alias -> eventsByAlias.put(alias, event));
        }
        for (MarkupType markup : markups) {
            this.markups.put(markup.name(), markup);
            markup.aliases().forEach(alias -> markupsByAlias.put(alias, markup));
        }
        taskClasses.forEach(t -> this.taskClasses.put(t.name(), t));
    }

    /** Id of the domain, such as {@code crw}. */
    public String domain() {
        return domain;
    }

    /** The ids of the domains whose words it joins; empty for a domain with words of its own alone. */
    public List<String> combines() {
        return combines;
    }

    /** How far the domain's robots get; empty where it does not say. */
    public Optional<Geography> geography() {
        return geography;
    }

    /** The fields that hold names of robots, each by the record or event that it is a field of. */
    public Map<String, String> robotNames() {
        return robotNames;
    }

    /** Declared enumerations and records by name, in order of declaration. */
    public Map<String, NamedType> types() {
        return Collections.unmodifiableMap(types);
    }

    /** Event types by name, in order of declaration. */
    public Map<String, EventType> events() {
        return Collections.unmodifiableMap(events);
    }

    /** Markup types by name, in order of declaration. */
    public Map<String, MarkupType> markups() {
        return Collections.unmodifiableMap(markups);
    }

    /** Task classes by name, in order of declaration. */
    public Map<String, TaskClass> taskClasses() {
        return Collections.unmodifiableMap(taskClasses);
    }

    /** The event type of that name or alias. */
    public Optional<EventType> event(String name) {
        EventType event = events.get(name);
        return Optional.ofNullable(event != null ? event : eventsByAlias.get(name));
    }

    /** What people call an event type: its title, else its name; of one that is not declared, what it is called here. */
    public String title(String type) {
        return event(type).map(EventType::title).orElse(type);
    }

    /** The first event type that has a role. */
    public Optional<EventType> eventWithRole(EventRole role) {
        return events.values().stream().filter(e -> e.role() == role).findFirst();
    }

    /** The markup type of that name or alias. */
    public Optional<MarkupType> markup(String name) {
        MarkupType markup = markups.get(name);
        return Optional.ofNullable(markup != null ? markup : markupsByAlias.get(name));
    }
}
