package org.sami.ui.command;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.sami.ui.look.Icons;

/**
 * Something that a person can have a window do, as a Swing action: buttons, menus, keys and the command search all run the same one. On the
 * event thread.
 *
 * <p>{@link #refresh} and each run check again whether it can be run; where it cannot, its tooltip says why.
 */
public final class Command extends AbstractAction {
    private final String id;
    private String title;
    private final Runnable run;
    private Supplier<Optional<String>> whyNot = Optional::empty;
    private Optional<KeyStroke> key = Optional.empty();
    private transient List<KeyStroke> focusKeys = List.of();
    private Optional<String> locked = Optional.empty();
    private UnaryOperator<String> words = UnaryOperator.identity();
    private boolean hidden;
    private boolean always;
    private boolean once;

    /**
     * A command that can always be run and has no key.
     *
     * @param id stable, in kebab case; the name of its buttons as well
     * @param title what people call it, such as "Start mission…"
     */
    public Command(String id, String title, Runnable run) {
        super(title);
        this.id = Objects.requireNonNull(id, "id");
        this.title = Objects.requireNonNull(title, "title");
        this.run = Objects.requireNonNull(run, "run");
        putValue(ACTION_COMMAND_KEY, id);
        describe(Optional.empty());
    }

    /**
     * Gives it a key.
     *
     * @param stroke as {@link KeyStroke#getKeyStroke(String)} reads it, such as {@code "ctrl shift P"} or {@code "F12"}
     * @throws IllegalArgumentException if that is no key
     */
    public Command withKey(String stroke) {
        KeyStroke read = KeyStroke.getKeyStroke(stroke);
        if (read == null) {
            throw new IllegalArgumentException("the command " + id + " has no key " + stroke);
        }
        key = Optional.of(read);
        putValue(ACCELERATOR_KEY, read);
        refresh();
        return this;
    }

    /** Calls it something else from now on, as what it acts on has changed. */
    public void retitle(String next) {
        title = words.apply(Objects.requireNonNull(next, "next"));
        putValue(NAME, title);
        refresh();
    }

    /**
     * Gives it keys that run it while what it acts on has the focus, such as a map ({@link #bindTo}): other commands may have them
     * elsewhere.
     */
    public Command withFocusKeys(List<KeyStroke> strokes) {
        focusKeys = List.copyOf(strokes);
        refresh();
        return this;
    }

    /** Has a component run it by its focus keys; where it cannot be run now, somebody else may have the key. */
    public void bindTo(JComponent component) {
        focusKeys.forEach(
                stroke -> component.getInputMap(JComponent.WHEN_FOCUSED).put(stroke, id));
        component.getActionMap().put(id, new AbstractAction(title) {
            @Override
            public boolean isEnabled() {
                return whyNot().isEmpty();
            }

            @Override
            public void actionPerformed(ActionEvent e) {
                Command.this.run();
            }
        });
    }

    /** Gives it an icon of {@link Icons}. */
    public Command withIcon(String icon) {
        putValue(SMALL_ICON, Icons.normal(icon));
        return this;
    }

    /** Gives it a condition: the reason why it cannot be run now, in one sentence; empty where it can. */
    public Command unless(Supplier<Optional<String>> reason) {
        whyNot = Objects.requireNonNull(reason, "reason");
        refresh();
        return this;
    }

    /** Its key works whatever has the focus, in dialogs too: for what stops things. */
    public Command always() {
        always = true;
        return this;
    }

    /**
     * Its key that is struck again at once, without another one between, or held until it repeats, is taken for one press: for what is followed by something
     * else that the second press would be taken for.
     */
    public Command once() {
        once = true;
        return this;
    }

    /** Takes it from the window's person: it is in no menu and no search, and no key runs it. */
    void hide() {
        hidden = true;
        lock("it is not part of this window");
    }

    /** Keeps it from being run until it is unlocked, for this reason. */
    void lock(String reason) {
        locked = Optional.of(reason);
        refresh();
    }

    /** Ends a lock. */
    void unlock() {
        if (locked.isPresent()) {
            locked = Optional.empty();
            refresh();
        }
    }

    /** Whether it is taken from the window's person. */
    public boolean isHidden() {
        return hidden;
    }

    /** Its stable id. */
    public String id() {
        return id;
    }

    /** What people call it. */
    public String title() {
        return title;
    }

    /** The key that runs it. */
    public Optional<KeyStroke> key() {
        return key;
    }

    /** The key in words, such as Ctrl+Shift+P, or the first that it has in what it acts on; empty text where it has none. */
    public String keyText() {
        return key.or(() -> focusKeys.stream().findFirst()).map(Command::text).orElse("");
    }

    /** Whether its key is also that of a character: where text is typed it is left to that. */
    public boolean isTyped() {
        return key.filter(stroke -> stroke.getModifiers() == 0)
                .map(KeyStroke::getKeyCode)
                .filter(code -> code == KeyEvent.VK_SPACE || (code >= KeyEvent.VK_COMMA && code <= KeyEvent.VK_Z))
                .isPresent();
    }

    boolean isOnce() {
        return once;
    }

    /** From now on its title and its reasons are said in other words. */
    void sayIn(UnaryOperator<String> other) {
        words = other;
        retitle(title);
    }

    boolean isAlways() {
        return always;
    }

    /** Why it cannot be run now, in one sentence; empty where it can. */
    public Optional<String> whyNot() {
        return locked.or(whyNot).map(words);
    }

    /** Asks again whether it can be run. */
    public void refresh() {
        Optional<String> reason = whyNot();
        setEnabled(reason.isEmpty());
        describe(reason);
    }

    private void describe(Optional<String> reason) {
        String keyed = keyText().isEmpty() ? title : title + " (" + keyText() + ")";
        putValue(Action.SHORT_DESCRIPTION, reason.map(why -> keyed + ": " + why).orElse(keyed));
    }

    /** Runs it, where it can be run now. */
    public void run() {
        refresh();
        if (isEnabled()) {
            run.run();
        }
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        run();
    }

    @Override
    protected Object clone() throws CloneNotSupportedException {
        throw new CloneNotSupportedException("a command is one of its id");
    }

    /** A key in words, such as Ctrl+Shift+P. */
    public static String text(KeyStroke stroke) {
        String modifiers = InputEvent.getModifiersExText(stroke.getModifiers());
        String name = KeyEvent.getKeyText(stroke.getKeyCode());
        return modifiers.isEmpty() ? name : modifiers + "+" + name;
    }
}
