package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.sami.crw.operator.mission.InterruptChoice;

/**
 * Where the buttons of interrupts stand, and which keys they have. Each mission has a group of its own, which keeps its place and its keys until the
 * mission ends: the room of an ended one stays empty below others, until a mission that fits begins. A key never comes to mean another interrupt.
 */
final class InterruptPlaces {
    /** How many keys there are. */
    static final int KEYS = 8;

    private final List<Group> groups = new ArrayList<>();
    private final List<String> names = new ArrayList<>(); // by number of key: the interrupt that it means
    private final Map<Held, Integer> numbers = new HashMap<>();

    /** A mission's interrupts; empty ones are room that an ended mission has left. */
    record Group(long mission, List<InterruptChoice> choices, int rows) {
        boolean isRoom() {
            return choices.isEmpty();
        }

        private Group ended() {
            return new Group(mission, List.of(), rows);
        }
    }

    private record Held(long mission, String name) {}

    /** Takes in what is offered now; says how the groups stand. */
    List<Group> show(List<InterruptChoice> choices) {
        Map<Long, List<InterruptChoice>> missions = new LinkedHashMap<>();
        choices.forEach(choice -> missions.computeIfAbsent(choice.mission(), id -> new ArrayList<>())
                .add(choice));
        groups.replaceAll(group -> missions.containsKey(group.mission())
                ? group(missions.get(group.mission()), group.rows())
                : group.ended());
        Set<Long> placed = new HashSet<>();
        groups.stream().filter(group -> !group.isRoom()).forEach(group -> placed.add(group.mission()));
        missions.forEach((mission, offered) -> {
            if (!placed.contains(mission)) {
                place(offered);
            }
        });
        while (!groups.isEmpty() && groups.get(groups.size() - 1).isRoom()) {
            groups.remove(groups.size() - 1);
        }
        numbers.keySet().removeIf(held -> !missions.containsKey(held.mission()));
        choices.forEach(this::number);
        return List.copyOf(groups);
    }

    private static Group group(List<InterruptChoice> offered, int rows) {
        List<InterruptChoice> apart = new ArrayList<>();
        offered.stream().filter(choice -> !choice.isFinal()).forEach(apart::add);
        offered.stream().filter(InterruptChoice::isFinal).forEach(apart::add);
        return new Group(offered.get(0).mission(), apart, Math.max(rows, apart.size()));
    }

    private void place(List<InterruptChoice> offered) {
        for (int i = 0; i < groups.size(); i++) {
            if (groups.get(i).isRoom() && groups.get(i).rows() >= offered.size()) {
                groups.set(i, group(offered, groups.get(i).rows()));
                return;
            }
        }
        groups.add(group(offered, 0));
    }

    private void number(InterruptChoice choice) {
        numbers.computeIfAbsent(new Held(choice.mission(), choice.name()), held -> {
            for (int i = 0; i < names.size(); i++) {
                if (names.get(i).equals(held.name()) && !numbers.containsValue(i)) {
                    return i;
                }
            }
            names.add(held.name());
            return names.size() - 1;
        });
    }

    /** The number of an interrupt's command, from 0; the first {@link #KEYS} have keys. */
    OptionalInt number(long mission, String name) {
        Integer number = numbers.get(new Held(mission, name));
        return number == null ? OptionalInt.empty() : OptionalInt.of(number);
    }

    /** The mission whose interrupt a command presses now; empty where none offers it. */
    Optional<Long> mission(int number) {
        return numbers.entrySet().stream()
                .filter(held -> held.getValue() == number)
                .map(held -> held.getKey().mission())
                .findFirst();
    }

    /** The interrupt that a command means; empty where it means none yet. */
    Optional<String> name(int number) {
        return number < names.size() ? Optional.of(names.get(number)) : Optional.empty();
    }

    /** How many commands mean an interrupt. */
    int count() {
        return names.size();
    }
}
