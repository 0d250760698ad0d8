package org.sami.crw.report.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.report.PictureResult;
import org.sami.crw.report.PicturesPart;
import org.sami.picture.photo.Photo;
import org.sami.picture.photo.PhotoReader;

/** The pictures of a report: copies of their files, and a page that shows them. A file that is no picture, or is gone, is a line of text there. */
final class PictureFiles {
    private static final int SHOWN_PX = 640;

    private PictureFiles() {}

    /** Copies the files into a folder next to the page, and makes the text of the page. */
    static String copy(PicturesPart part, String title, Path folder) throws IOException {
        Map<String, StringBuilder> groups = new LinkedHashMap<>();
        for (PictureResult one : part.pictures()) {
            String head = String.format(
                    Locale.ROOT,
                    "%s, %.1f s, %.6f, %.6f",
                    one.boat(),
                    one.atMillis() / 1000.0,
                    one.latDeg(),
                    one.lonDeg());
            groups.computeIfAbsent(head, none -> new StringBuilder()).append(figure(one, copied(one, folder)));
        }
        StringBuilder page =
                new StringBuilder("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>");
        page.append(html(title))
                .append("</title>\n<style>\n")
                .append("body { font-family: sans-serif; margin: 24px; color: #16202a; background: #ffffff; }\n")
                .append("div { display: flex; flex-wrap: wrap; gap: 8px; }\n")
                .append("figure { margin: 0; width: 320px; }\nimg { width: 100%; }\n")
                .append("figcaption { font-size: 13px; color: #55606c; }\n</style>\n</head>\n<body>\n<h1>")
                .append(html(title))
                .append("</h1>\n");
        groups.forEach((head, figures) -> page.append("<h2>")
                .append(html(head))
                .append("</h2>\n<div>\n")
                .append(figures)
                .append("</div>\n"));
        return page.append("</body>\n</html>\n").toString();
    }

    /** Why a picture cannot be shown; empty where it is copied and can. */
    private static Optional<String> copied(PictureResult one, Path folder) throws IOException {
        if (one.file().isEmpty()) {
            return Optional.of(one.missed().isEmpty() ? "had not come when the report was made" : one.missed());
        }
        Path to = folder.resolve(one.path());
        Files.createDirectories(to.getParent());
        try {
            if (!to.toAbsolutePath().equals(one.file().get().toAbsolutePath())) {
                Files.copy(one.file().get(), to, StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (NoSuchFileException e) {
            return Optional.of("is no longer in the folder of the session");
        }
        Photo photo = PhotoReader.read(to, SHOWN_PX, SHOWN_PX);
        return photo.problem().isEmpty() ? Optional.empty() : Optional.of(photo.problem());
    }

    private static String figure(PictureResult one, Optional<String> problem) {
        String path = html(one.path());
        String name = html(one.name());
        return problem.map(words -> "<figure><figcaption>" + name + ": " + html(words) + "</figcaption></figure>\n")
                .orElseGet(() -> "<figure><a href=\"" + path + "\"><img src=\"" + path + "\" alt=\"" + name
                        + "\" loading=\"lazy\"></a><figcaption>" + name + "</figcaption></figure>\n");
    }

    private static String html(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
