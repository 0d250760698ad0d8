package org.sami.crw.gui.mission;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.spn.protocol.Ids;
import org.sami.ui.command.Command;

/**
 * A command for each interrupt that a mission has offered, found by typing its name. The first eight have keys, which stay theirs as long as the
 * window is open: a key never comes to mean another interrupt. A command presses the interrupt for every mission that offers it; one for boats
 * for those that are selected.
 */
final class InterruptCommands {
    private static final int FIRST_KEY = 2;
    private static final int LAST_KEY = 9;

    private final OperatorContext context;
    private final Map<String, Command> commands = new LinkedHashMap<>();

    InterruptCommands(OperatorContext context) {
        this.context = context;
    }

    /** Adds commands of interrupts that are offered for the first time, and says anew which can be pressed. */
    void show(List<InterruptChoice> choices) {
        choices.forEach(choice -> commands.computeIfAbsent(choice.name(), this::added));
        commands.values().forEach(Command::refresh);
    }

    /** The key of an interrupt that was offered, in words; empty text for none. */
    String keyText(String interrupt) {
        return commands.get(interrupt).keyText();
    }

    private Command added(String interrupt) {
        int number = commands.size() + 1;
        Command command = new Command("interrupt-" + number, "Interrupt: " + interrupt, () -> press(interrupt))
                .withIcon("interrupt")
                .unless(() -> whyNot(interrupt));
        int key = FIRST_KEY + number - 1;
        return context.commands().add(key <= LAST_KEY ? command.withKey("ctrl F" + key) : command);
    }

    private Optional<String> whyNot(String interrupt) {
        List<InterruptChoice> choices = choices(interrupt);
        return context.whyNotAct()
                .or(() -> choices.isEmpty() ? Optional.of("no running mission offers it") : Optional.empty())
                .or(() -> choices.stream().anyMatch(InterruptChoice::isEnabled)
                        ? Optional.empty()
                        : Optional.of(choices.get(0).whyNot()));
    }

    private List<InterruptChoice> choices(String interrupt) {
        return context.models().interrupts().snapshot().stream()
                .filter(choice -> choice.name().equals(interrupt))
                .toList();
    }

    private void press(String interrupt) {
        List<String> boats = choices(interrupt).stream().anyMatch(InterruptChoice::asksForBoats)
                ? context.boats().boats()
                : List.of();
        context.tell(
                context.session().press(interrupt, Ids.NONE, boats),
                "Pressed " + interrupt + (boats.isEmpty() ? "" : " for " + String.join(", ", boats)));
    }
}
