package org.sami.dreamm.window;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Optional;
import org.sami.dreamm.context.DomainSource;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.EventThread;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;

/**
 * Loads what the window needs, without a display, so that the Java that runs this can keep its classes in an archive from which the program starts
 * faster. The start script calls it when the program is installed.
 */
final class ClassArchive {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 700;

    private ClassArchive() {}

    /** Makes every panel over the library and paints it into memory. */
    public static void main(String[] args) {
        DomainLibrary domain = DomainSource.SHIPPED.library().orThrow();
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            ProjectDocument document =
                    new ProjectDocument(domain.vocabulary(), LibraryProject.of(domain), Optional.empty());
            DreammContext context = new DreammContext(domain, document, Profile.ALL);
            RunParts run = new RunParts(context);
            for (DockPanel panel : new DreammPanels(context, run).all()) {
                panel.setSize(WIDTH, HEIGHT);
                panel.doLayout();
                Graphics2D g = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB).createGraphics();
                panel.paint(g);
                g.dispose();
            }
            return null;
        });
        System.exit(0);
    }
}
