package org.sami.ui.command;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import javax.swing.KeyStroke;

/** The commands of a window, in order of registration. On the event thread. */
public final class CommandRegistry {
    private final Map<String, Command> commands = new LinkedHashMap<>();
    private final Map<KeyStroke, Command> keys = new LinkedHashMap<>();
    private final CommandPolicy policy;
    private final UnaryOperator<String> words;

    /** Commands that are all there. */
    public CommandRegistry() {
        this(CommandPolicy.ALL);
    }

    /** Commands of which some may be hidden or locked. */
    public CommandRegistry(CommandPolicy policy) {
        this(policy, UnaryOperator.identity());
    }

    /** Commands whose titles and reasons are said in a domain's words. */
    public CommandRegistry(CommandPolicy policy, UnaryOperator<String> words) {
        this.policy = Objects.requireNonNull(policy, "policy");
        this.words = Objects.requireNonNull(words, "words");
    }

    /**
     * Adds a command.
     *
     * @return the command
     * @throws IllegalArgumentException if another has its id or its key
     */
    public Command add(Command command) {
        if (commands.containsKey(command.id())) {
            throw new IllegalArgumentException("there are two commands " + command.id());
        }
        command.key().ifPresent(key -> {
            Command other = keys.putIfAbsent(key, command);
            if (other != null) {
                throw new IllegalArgumentException(
                        "the commands " + other.id() + " and " + command.id() + " have one key, " + command.keyText());
            }
        });
        commands.put(command.id(), command);
        command.sayIn(words);
        if (!policy.shows(command.id())) {
            command.hide();
        } else {
            policy.whyLocked(command.id()).ifPresent(command::lock);
        }
        return command;
    }

    /** All of them that are not hidden. */
    public Collection<Command> all() {
        return commands.values().stream().filter(command -> !command.isHidden()).toList();
    }

    /** The ids of all of them, of those that are hidden as well. */
    public Set<String> ids() {
        return Collections.unmodifiableSet(commands.keySet());
    }

    /** The command of an id, hidden or not. */
    public Optional<Command> find(String id) {
        return Optional.ofNullable(commands.get(id));
    }

    /** The command of an id that is known to be there.
     *
     * @throws IllegalArgumentException if it is not
     */
    public Command get(String id) {
        return find(id).orElseThrow(() -> new IllegalArgumentException("there is no command " + id));
    }

    /** The command that a key runs. */
    public Optional<Command> ofKey(KeyStroke key) {
        return Optional.ofNullable(keys.get(key)).filter(command -> !command.isHidden());
    }

    /** Why the policy keeps what a command of an id does from being done, also where something else than the command would do it; empty where it does not. */
    public Optional<String> whyLocked(String id) {
        return policy.whyLocked(id).map(words);
    }

    /** Asks the policy again what is locked, as it may say otherwise now; what it hid stays hidden. */
    public void askPolicy() {
        for (Command command : all()) {
            policy.whyLocked(command.id()).ifPresentOrElse(command::lock, command::unlock);
        }
    }

    /** Asks all commands again whether they can be run: to be called when what they depend on has changed. */
    public void refresh() {
        commands.values().forEach(Command::refresh);
    }
}
