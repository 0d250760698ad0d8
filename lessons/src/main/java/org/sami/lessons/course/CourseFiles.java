package org.sami.lessons.course;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.sami.spn.json.BoundedFile;

/** Where the files of a course are: those that ship, or a folder. */
public interface CourseFiles {
    /** The course that ships. */
    CourseFiles SHIPPED = onClassPath("org/sami/lessons/course");

    /**
     * The text of a file.
     *
     * @param path below the course, with slashes
     * @return empty where there is no such file
     * @throws IOException if it cannot be read, or is too large
     */
    Optional<String> text(String path) throws IOException;

    /** What a file is called in messages. */
    String name(String path);

    /** The files of a folder on the class path. */
    static CourseFiles onClassPath(String folder) {
        return new CourseFiles() {
            @Override
            public Optional<String> text(String path) throws IOException {
                try (InputStream in = CourseFiles.class.getClassLoader().getResourceAsStream(folder + "/" + path)) {
                    return in == null
                            ? Optional.empty()
                            : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
                }
            }

            @Override
            public String name(String path) {
                return path;
            }
        };
    }

    /** The files of a folder. */
    static CourseFiles in(Path folder) {
        return new CourseFiles() {
            @Override
            public Optional<String> text(String path) throws IOException {
                Path file = folder.resolve(path).normalize();
                return file.startsWith(folder.normalize()) && Files.isRegularFile(file)
                        ? Optional.of(BoundedFile.text(file, BoundedFile.PROJECT_BYTES))
                        : Optional.empty();
            }

            @Override
            public String name(String path) {
                return folder.resolve(path).toString();
            }
        };
    }
}
