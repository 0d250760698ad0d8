package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.ui.command.Command;

/**
 * A command for each interrupt of each mission, found by typing its name. The first eight have keys, which are there from the beginning: one that means
 * no interrupt says so. A command presses the interrupt of one mission, as its button does.
 */
final class InterruptCommands {
    private static final int FIRST_KEY = 2;

    private final OperatorContext context;
    private final InterruptPlaces places;
    private final InterruptPress press;
    private final List<Command> commands = new ArrayList<>();
    private final Command withdraw;

    InterruptCommands(OperatorContext context, InterruptPlaces places, InterruptPress press) {
        this.context = context;
        this.places = places;
        this.press = press;
        for (int number = 0; number < InterruptPlaces.KEYS; number++) {
            commands.add(added(number).withKey("ctrl F" + (FIRST_KEY + number)));
            context.commands().add(commands.get(number));
        }
        withdraw = context.commands()
                .add(new Command(
                                "interrupt-withdraw",
                                "Withdraw the interrupt that asks which boats it is for",
                                () -> press.asking().ifPresent(press::withdraw))
                        .withKey("ctrl shift Z")
                        .withIcon("undo")
                        .unless(() -> context.whyNotAct()
                                .or(() -> press.asking().isPresent()
                                        ? Optional.empty()
                                        : Optional.of("no interrupt asks which boats it is for"))));
    }

    /** Says again which command presses what; adds those that have no key. */
    void show() {
        while (commands.size() < places.count()) {
            commands.add(context.commands().add(added(commands.size())));
        }
        for (int number = 0; number < places.count(); number++) {
            commands.get(number).retitle(title(number));
        }
        commands.forEach(Command::refresh);
        withdraw.refresh();
    }

    /** The key of an interrupt, in words; empty text for none. */
    String keyText(InterruptChoice choice) {
        OptionalInt number = places.number(choice.mission(), choice.name());
        return number.isPresent() ? commands.get(number.getAsInt()).keyText() : "";
    }

    /** The key that withdraws, in words. */
    String withdrawKey() {
        return withdraw.keyText();
    }

    private Command added(int number) {
        return new Command(
                        "interrupt-" + (number + 1),
                        "Interrupt of this key",
                        () -> choice(number).ifPresent(press::press))
                .withIcon("interrupt")
                .unless(() -> whyNot(number));
    }

    private String title(int number) {
        return choice(number)
                .map(choice -> "Interrupt: " + press.title(choice))
                .orElse("Interrupt: " + places.name(number).orElse(""));
    }

    private Optional<InterruptChoice> choice(int number) {
        Optional<String> name = places.name(number);
        Optional<Long> mission = places.mission(number);
        return context.models().interrupts().snapshot().stream()
                .filter(choice -> mission.filter(id -> id == choice.mission()).isPresent()
                        && name.filter(choice.name()::equals).isPresent())
                .findFirst();
    }

    private Optional<String> whyNot(int number) {
        if (places.name(number).isEmpty()) {
            return context.whyNotAct().or(() -> Optional.of("no mission has an interrupt with this key"));
        }
        Optional<InterruptChoice> choice = choice(number);
        return choice.isPresent()
                ? press.whyNot(choice.get())
                : context.whyNotAct().or(() -> Optional.of("no running mission offers it"));
    }
}
