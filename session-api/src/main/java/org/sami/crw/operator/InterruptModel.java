package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.operator.mission.InterruptChoice;

/**
 * The buttons for interrupts of running missions, in order of missions and plans; those that cannot be pressed now say why. One that was offered keeps
 * its place among those of its mission until that ends.
 */
public final class InterruptModel extends Model<List<InterruptChoice>> {
    private List<InterruptChoice> buttons = List.of();

    InterruptModel() {
        super(List.of());
    }

    void show(List<InterruptChoice> told) {
        Map<Long, Map<String, InterruptChoice>> now = new LinkedHashMap<>();
        told.forEach(choice -> now.computeIfAbsent(choice.mission(), id -> new LinkedHashMap<>())
                .put(choice.name(), choice));
        List<InterruptChoice> next = new ArrayList<>();
        now.forEach((mission, choices) -> {
            for (InterruptChoice before : buttons) {
                if (before.mission() == mission) {
                    InterruptChoice same = choices.remove(before.name());
                    next.add(same == null ? before.notOffered() : same);
                }
            }
            next.addAll(choices.values());
        });
        buttons = List.copyOf(next);
        change();
    }

    @Override
    List<InterruptChoice> take() {
        return buttons;
    }
}
