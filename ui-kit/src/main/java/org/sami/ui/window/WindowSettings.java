package org.sami.ui.window;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Properties;
import org.sami.palette.Theme;
import org.sami.ui.look.Look;

/** What a person has set in the window, in a file of properties. What cannot be read there is as at first. On the event thread. */
public final class WindowSettings {
    private static final System.Logger LOG = System.getLogger(WindowSettings.class.getName());
    private static final String THEME = "theme";
    private static final String SCALE = "scale";
    private static final String HIGH_ROWS = "high-rows";

    private final Path file;
    private final Properties values = new Properties();

    /** The settings of a file, which need not be there. */
    public WindowSettings(Path file) {
        this.file = file;
        if (Files.exists(file)) {
            try (Reader reader = Files.newBufferedReader(file)) {
                values.load(reader);
            } catch (IOException | IllegalArgumentException unfit) {
                LOG.log(System.Logger.Level.WARNING, file + " cannot be read, its settings are as at first", unfit);
            }
        }
    }

    /** The theme that was chosen. */
    public Theme theme() {
        return Theme.of(values.getProperty(THEME, "")).orElse(Theme.LIGHT);
    }

    /** The scale that was chosen, in percent. */
    public int scale() {
        try {
            return Integer.parseInt(values.getProperty(SCALE, "100"));
        } catch (NumberFormatException unfit) {
            return 100;
        }
    }

    /** Whether high rows were chosen. */
    public boolean highRows() {
        return Boolean.parseBoolean(values.getProperty(HIGH_ROWS, "false"));
    }

    /** A text that was kept, such as the parameters of a plan; empty where there is none. */
    public String text(String key) {
        return values.getProperty(key, "");
    }

    /** Keeps a text. */
    public void keep(String key, String text) {
        values.setProperty(key, text);
        write();
    }

    /** Keeps the look in force. */
    public void keepLook() {
        values.setProperty(THEME, Look.theme().id());
        values.setProperty(SCALE, Integer.toString(Look.scalePercent()));
        values.setProperty(HIGH_ROWS, Boolean.toString(Look.hasHighRows()));
        write();
    }

    private void write() {
        Path next = file.resolveSibling(file.getFileName() + ".new");
        try {
            try (Writer writer = Files.newBufferedWriter(next)) {
                values.store(writer, null);
            }
            Files.move(next, file, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException full) {
            LOG.log(System.Logger.Level.WARNING, file + " cannot be written, settings are lost with the window", full);
        }
    }
}
