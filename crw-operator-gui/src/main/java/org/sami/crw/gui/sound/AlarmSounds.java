package org.sami.crw.gui.sound;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.window.WindowSettings;

/** Lets alarms of a session be heard, by severity, until they are acknowledged, muted or over; all of it can be turned off. On the event thread. */
public final class AlarmSounds implements AutoCloseable {
    private static final String KEY = "alarm-sounds";
    private static final String OFF = "off";
    private static final int PERIOD_MS = 500;
    private static final long NANOS_A_MS = 1_000_000;

    private final OperatorContext context;
    private final WindowSettings settings;
    private final AlarmTimes times = new AlarmTimes();
    private final Consumer<AlarmTone> play;
    private final Runnable closing;
    private final Timer timer = new Timer(PERIOD_MS, e -> look());
    private boolean on;

    /** Sounds of a session on this machine's loudspeaker, as they were left: on or off. */
    public static AlarmSounds of(OperatorContext context, WindowSettings settings) {
        Loudspeaker speaker =
                new Loudspeaker(why -> EventThread.later(() -> context.notices().refused(why)));
        AlarmSounds sounds = new AlarmSounds(context, settings, speaker::play, speaker::close);
        sounds.timer.start();
        return sounds;
    }

    AlarmSounds(OperatorContext context, WindowSettings settings, Consumer<AlarmTone> play, Runnable closing) {
        this.context = context;
        this.settings = settings;
        this.play = play;
        this.closing = closing;
        on = !OFF.equals(settings.text(KEY));
        context.commands()
                .add(new Command("alarm-sounds", "Alarm sounds on or off", this::toggle)
                        .withKey("ctrl shift V")
                        .withIcon("bell"));
        for (AlarmTone tone : AlarmTone.values()) {
            String name = tone.name().toLowerCase(Locale.ROOT);
            context.commands()
                    .add(new Command(
                            "alarm-hear-" + name, "Hear how a " + name + " alarm sounds", () -> play.accept(tone)));
        }
    }

    /** Whether alarms are heard. */
    boolean isOn() {
        return on;
    }

    private void toggle() {
        on = !on;
        settings.keep(KEY, on ? "on" : OFF);
        context.notices().show(on ? "Alarms are heard again" : "Alarms make no sound; they are seen as before");
    }

    /** Looks whether something is to be heard. */
    void look() {
        Optional<AlarmTone> tone = times.next(context.models().alarms().snapshot(), System.nanoTime() / NANOS_A_MS);
        if (on) {
            tone.ifPresent(play);
        }
    }

    @Override
    public void close() {
        timer.stop();
        closing.run();
    }
}
