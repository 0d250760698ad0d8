package org.sami.crw.console;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.session.Session;
import org.sami.crw.session.archive.SavedGlobals;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.sim.run.settings.ValueText;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.TextNumbers;
import org.sami.spn.value.Value;

/** Commands about the session itself: variables, waiting, help and the end. */
final class SessionCommands {
    private static final double STANDARD_WAIT_S = 600;
    private static final String BOATS = "boats";

    private final ConsoleContext context;
    private final Supplier<Collection<ConsoleCommand>> commands;
    private volatile boolean ended;
    private boolean hadMission; // as seen while it waited for the end

    /** @param commands all of the console, for its help */
    SessionCommands(ConsoleContext context, Supplier<Collection<ConsoleCommand>> commands) {
        this.context = context;
        this.commands = commands;
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of("globals", "Lists the variables of the project and their values now.", this::globals),
                ConsoleCommand.of(
                        "set @NAME VALUE",
                        "Gives a variable of the project a value.",
                        this::set,
                        words -> globalNames()),
                ConsoleCommand.of(
                        "save FILE",
                        "Writes the variables' values into a project's file as its initial ones.",
                        this::save),
                ConsoleCommand.of("load FILE", "Loads a project; running missions keep their plans.", this::load),
                ConsoleCommand.of(
                        "wait decision|alarm|ended|tasks|boats N|SECONDS [within SECONDS]",
                        "Waits until something is asked, something is wrong, no mission runs, boats have tasks, N"
                                + " boats are linked and tell where they are, or for a time.",
                        this::await,
                        words -> words.size() > 1
                                ? List.of("within")
                                : List.of(
                                        "decision",
                                        "alarm",
                                        "ended",
                                        "tasks",
                                        context.words().typed(BOATS))),
                ConsoleCommand.of(
                        "on-fault [hold|stop]",
                        "Says, or sets, what boats of missions do while the engine or its journal does not work.",
                        this::onFault,
                        words -> Stream.of(BoatsAtFault.values())
                                .map(BoatsAtFault::typed)
                                .toList()),
                ConsoleCommand.of(
                        "help [COMMAND]",
                        "Lists the commands, or says more of one.",
                        this::help,
                        words -> commandNames()),
                ConsoleCommand.of(
                        "quit",
                        Session.inProcess(context.session()).isPresent()
                                ? "Stops the boats of all missions, as far as links stand, and ends."
                                : "Leaves the session, which goes on.",
                        this::quit));
    }

    /** No further command is read. From any thread. */
    void end() {
        ended = true;
    }

    /** Whether the operator wants the session to end. */
    boolean hasEnded() {
        return ended;
    }

    private List<String> globalNames() {
        return context.project().globals().stream().map(VariableSpec::name).toList();
    }

    private List<String> commandNames() {
        return commands.get().stream().map(ConsoleCommand::name).toList();
    }

    private void globals(Arguments arguments, Consumer<String> out) {
        arguments.end();
        if (globalNames().isEmpty()) {
            out.accept("the project has no variables of its own");
        }
        Map<String, Value> values = context.await(context.session().ask(EngineView::globals));
        for (String name : globalNames()) {
            out.accept(name + " = "
                    + Optional.ofNullable(values.get(name))
                            .map(EngineText::value)
                            .orElse("no value"));
        }
    }

    private void set(Arguments arguments, Consumer<String> out) {
        String name = arguments.next("variable");
        VariableSpec variable = context.project().globals().stream()
                .filter(one -> one.name().equals(name) || one.name().equals("@" + name))
                .findFirst()
                .orElseThrow(() -> new ConsoleFault("the project has no variable '" + name + "'"
                        + (globalNames().isEmpty() ? "" : "; it has " + String.join(", ", globalNames()))));
        String text = arguments.next("value");
        arguments.end();
        List<Finding> findings = new ArrayList<>();
        Value value = ValueText.parse(
                        text, variable.type(), context.vocabulary().types(), findings)
                .orElseThrow(() -> new ConsoleFault(
                        name + " cannot be '" + text + "': expected is " + ValueText.form(variable.type())));
        context.await(context.session().setVariable(Ids.NONE, variable.name(), value));
        out.accept(variable.name() + " = " + EngineText.value(value));
    }

    private void save(Arguments arguments, Consumer<String> out) {
        Path file = file(arguments);
        SavedGlobals saved =
                context.await(context.inProcess("files are saved on").project().saveGlobals(file));
        saved.changes().forEach(change -> out.accept(change.name() + " = " + EngineText.value(change.after())));
        saved.warnings().forEach(warning -> out.accept(warning.message()));
        out.accept(saved.changes().isEmpty() ? file + " has these values already" : "saved to " + file);
    }

    private void load(Arguments arguments, Consumer<String> out) {
        Path file = file(arguments);
        int version = context.await(
                context.inProcess("projects are loaded on").project().load(file));
        out.accept("loaded " + file + " as project " + version + "; missions that start now have its plans: "
                + String.join(", ", context.plans()));
    }

    private static Path file(Arguments arguments) {
        Path file = Path.of(arguments.next("file"));
        arguments.end();
        if (!Files.exists(file)) {
            throw new ConsoleFault("there is no file " + file);
        }
        return file;
    }

    private void await(Arguments arguments, Consumer<String> out) {
        String typed = arguments.next("occasion");
        String what = typed.equals(context.words().typed(BOATS)) ? BOATS : typed;
        long count = what.equals(BOATS) ? arguments.number("number of boats") : 0;
        double limit = STANDARD_WAIT_S;
        if (arguments.hasNext()) {
            String word = arguments.next("within");
            if (!word.equals("within")) {
                throw new ConsoleFault("'" + word + "' is too much; a limit is given as: within SECONDS");
            }
            limit = arguments.real("time");
        }
        arguments.end();
        BooleanSupplier wanted = switch (what) {
            case "decision" -> () -> !context.models().decisions().pending().isEmpty();
            case "alarm" -> () -> !context.models().alarms().snapshot().isEmpty();
            case "ended" -> this::noMissionRuns;
            case "tasks" ->
                () -> !context.models().allocation().snapshot().queues().isEmpty();
            case BOATS -> () -> ready() >= count;
            default -> null;
        };
        if (wanted == null) {
            context.until(() -> false, seconds(what));
        } else if (!context.until(wanted, limit)) {
            throw new ConsoleFault("still not after " + Numbers.short1(limit) + " s: wait " + what);
        } else {
            context.catchUp(); // what comes next may be quit, and ends the telling
        }
    }

    private static double seconds(String word) {
        return TextNumbers.real(word, 0, 86_400)
                .orElseThrow(() -> new ConsoleFault(
                        "waits for decision, alarm, ended, tasks, boats N, or 0 to 86400 seconds, not for '" + word
                                + "'"));
    }

    /** A mission that ended while there was no link to the session's base is not among its missions any longer. */
    private boolean noMissionRuns() {
        MissionsSnapshot missions = context.models().missions().snapshot();
        hadMission |= !missions.missions().isEmpty();
        return hadMission && missions.running().isEmpty();
    }

    private long ready() {
        return context.models().fleet().snapshot().stream()
                .filter(boat -> boat.link() == LinkState.LINKED && boat.pose().isPresent())
                .count();
    }

    private void onFault(Arguments arguments, Consumer<String> out) {
        if (arguments.hasNext()) {
            String word = arguments.next("choice");
            arguments.end();
            BoatsAtFault chosen = Stream.of(BoatsAtFault.values())
                    .filter(one -> one.typed().equals(word))
                    .findFirst()
                    .orElseThrow(() -> new ConsoleFault("on a fault boats hold or stop, they do not '" + word + "'"));
            context.inProcess("what boats do on a fault is set on").faults().setBoats(chosen);
        }
        BoatsAtFault still =
                context.inProcess("what boats do on a fault is set on").faults().boats();
        out.accept("on a fault of engine or journal: " + still.typed() + " (" + still.words() + ")");
    }

    private void help(Arguments arguments, Consumer<String> out) {
        if (arguments.hasNext()) {
            String name = arguments.next("command");
            arguments.end();
            ConsoleCommand command = commands.get().stream()
                    .filter(one -> one.name().equals(name))
                    .findFirst()
                    .orElseThrow(() -> new ConsoleFault("there is no command '" + name + "'"));
            out.accept(command.usage());
            out.accept("  " + command.help());
            return;
        }
        int width = commands.get().stream()
                .mapToInt(c -> c.usage().length())
                .filter(w -> w <= 36)
                .max()
                .orElse(0);
        for (ConsoleCommand command : commands.get()) {
            out.accept(String.format(Locale.ROOT, "%-" + width + "s  %s", command.usage(), command.help()));
        }
    }

    private void quit(Arguments arguments, Consumer<String> out) {
        arguments.end();
        ended = true;
    }
}
