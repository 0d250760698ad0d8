package org.sami.lessons.site;

import java.io.IOException;
import java.nio.file.Path;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;

/** Writes the course that ships as a folder of pages: {@code ./gradlew lessonsSite}. */
public final class CourseSiteMain {
    private CourseSiteMain() {}

    /**
     * Writes them.
     *
     * @param args the folder
     */
    public static void main(String[] args) throws IOException {
        if (args.length != 1) {
            throw new IOException("one argument is needed, the folder of the pages");
        }
        Path folder = Path.of(args[0]);
        DomainLibrary domain =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Course course = CourseReader.read(CourseFiles.SHIPPED, domain).orThrow();
        int pages = new CourseSite(course, domain.vocabulary()).write(folder);
        System.out.println(
                pages + " pages of " + course.lessons().size() + " lessons: " + folder.resolve("index.html"));
    }
}
