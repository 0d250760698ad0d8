package org.sami.crw.operator;

import java.util.List;
import org.sami.crw.operator.mission.InterruptChoice;

/** The buttons for interrupts of running missions, in order of missions and plans; those that cannot be pressed now say why. */
public final class InterruptModel extends Model<List<InterruptChoice>> {
    private List<InterruptChoice> buttons = List.of();

    InterruptModel() {
        super(List.of());
    }

    void show(List<InterruptChoice> told) {
        buttons = told;
        change();
    }

    @Override
    List<InterruptChoice> take() {
        return List.copyOf(buttons);
    }
}
