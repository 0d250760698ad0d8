package org.sami.ui.look;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.util.UIScale;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import net.miginfocom.layout.PlatformDefaults;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;

/**
 * The theme and the scale of all windows, which can change while they are open. On the event thread.
 *
 * <p>Painted components ask {@link SemanticColor}, {@link Fonts} and {@link #px} again each time that they paint; those that keep what they
 * asked register a listener.
 */
public final class Look {
    /** The scales that a menu offers, in percent. */
    public static final List<Integer> SCALES = List.of(80, 90, 100, 110, 125, 150, 175, 200);

    /** The smallest scale, in percent. */
    public static final int LEAST = LookScale.LEAST;

    /** The largest scale, in percent. */
    public static final int MOST = LookScale.MOST;

    private static final List<Runnable> LISTENERS = new CopyOnWriteArrayList<>();
    private static volatile boolean highRows;
    private static volatile int hitTarget = Spacing.HIT_TARGET;

    private Look() {}

    /**
     * Gives all windows a theme and a scale; those that are open change at once.
     *
     * @param percent 80 to 200; what lies outside is brought to the nearer end
     */
    public static void apply(Theme next, int percent) {
        next.putInForce();
        LookScale.put(percent);
        UIScale.setZoomFactor(1); // else the font's size would be taken as one at the scale that was
        UIManager.put("defaultFont", Fonts.base());
        PlainTextUI.install();
        try {
            UIManager.setLookAndFeel(laf(next));
        } catch (UnsupportedLookAndFeelException e) {
            throw new IllegalStateException("the look of the theme " + next.id() + " does not run here", e);
        }
        UIScale.setZoomFactor(LookScale.percent() / 100f);
        PlatformDefaults.setLogicalPixelBase(
                PlatformDefaults.BASE_SCALE_FACTOR); // it asks the look for its scale by itself
        FlatLaf.updateUI();
        LISTENERS.forEach(Runnable::run);
    }

    private static FlatLaf laf(Theme theme) {
        return switch (theme) {
            case LIGHT -> new LightLaf();
            case DARK -> new DarkLaf();
            case SUN -> new SunLaf();
        };
    }

    /** The theme in force. */
    public static Theme theme() {
        return Theme.inForce();
    }

    /** The scale in force, in percent. */
    public static int scalePercent() {
        return LookScale.percent();
    }

    /** Makes rows of tables and lists high enough for wet fingers from the next {@link #apply} on, or as high as their text needs. */
    public static void setHighRows(boolean high) {
        highRows = high;
    }

    /** Makes what is clicked large enough for wet fingers in windows that are made from now on. */
    public static void useFieldTargets() {
        hitTarget = Spacing.HIT_TARGET_FIELD;
    }

    /** The least height and width of what is clicked, in logical pixels. */
    public static int hitTarget() {
        return hitTarget;
    }

    /** Whether rows of tables and lists are high enough for wet fingers. */
    public static boolean hasHighRows() {
        return highRows;
    }

    /** The next larger or smaller of {@link #SCALES}; the one in force where there is none. */
    public static int nextScale(boolean larger) {
        return larger
                ? SCALES.stream()
                        .filter(each -> each > LookScale.percent())
                        .findFirst()
                        .orElse(LookScale.percent())
                : SCALES.stream()
                        .filter(each -> each < LookScale.percent())
                        .reduce((a, b) -> b)
                        .orElse(LookScale.percent());
    }

    /** Logical pixels as pixels at the scale in force. */
    public static int px(int logical) {
        return Math.round(logical * LookScale.percent() / 100f);
    }

    /** Calls a listener after theme or scale have changed. */
    public static void addListener(Runnable listener) {
        LISTENERS.add(listener);
    }

    /** Removes a listener. */
    public static void removeListener(Runnable listener) {
        LISTENERS.remove(listener);
    }
}
