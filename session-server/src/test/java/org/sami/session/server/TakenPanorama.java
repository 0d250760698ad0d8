package org.sami.session.server;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Three pictures of the boat bella: a photograph's size and noise, a file that is none, and one that has not come. */
final class TakenPanorama {
    static final String QUERY = "picture?boat=bella&panorama=p1&name=";

    private TakenPanorama() {}

    /** Lets a session know the pictures, as if they had come from the boat. */
    static void give(Session session, Path folder) throws IOException {
        Path photograph = folder.resolve("a.jpg");
        ImageIO.write(noise(1600, 1200), "jpg", photograph.toFile());
        Path page = Files.writeString(folder.resolve("b.jpg"), "<script>alert(1)</script>");
        Panorama command = new Panorama("p1", 1, Ids.NONE, 3, Priority.MEDIUM);
        session.models()
                .pictures()
                .restore(
                        new FleetEvent.PanoramaTaken(
                                "bella", command, 3, GeoPoint.of(45.4, 10.9), List.of("a.jpg", "b.jpg", "c.jpg")),
                        1000);
        session.models().pictures().restore(new FleetEvent.PictureFetched("bella", "p1", "a.jpg", photograph), 2000);
        session.models().pictures().restore(new FleetEvent.PictureFetched("bella", "p1", "b.jpg", page), 2000);
    }

    private static BufferedImage noise(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(1);
        Graphics2D g = image.createGraphics();
        for (int i = 0; i < 40_000; i++) {
            g.setColor(new Color(random.nextInt(0x1000000)));
            g.fillRect(random.nextInt(width), random.nextInt(height), 12, 12);
        }
        g.dispose();
        return image;
    }
}
