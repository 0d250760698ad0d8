package org.sami.house

import groovy.xml.XmlSlurper

/** Counts the tests of JUnit's XML result files, so that the last word of a build is what was run, not what was planned. */
class TestCount {
    int passed
    int failed
    int skipped
    private final List<String> failures = []

    /** Adds every result file of one module's test task. */
    void addFolder(File folder) {
        folder.listFiles()?.findAll { it.name ==~ /TEST-.*\.xml/ }?.sort()?.each { addFile(it) }
    }

    private void addFile(File file) {
        def suite = new XmlSlurper(false, false).parse(file)
        int all = (suite.@tests.text() ?: '0') as int
        int bad = ((suite.@failures.text() ?: '0') as int) + ((suite.@errors.text() ?: '0') as int)
        int left = (suite.@skipped.text() ?: '0') as int
        passed += all - bad - left
        failed += bad
        skipped += left
        suite.testcase.each { test ->
            def faults = test.failure.list() + test.error.list()
            if (faults) {
                String message = faults[0].@message.text().readLines().findAll { !it.blank }.take(3)*.trim().join(' ')
                failures << "FAILED ${test.@classname.text()} ${test.@name.text()}: $message"
            }
        }
    }

    /** Which tests failed, and last the count, always in the same words; what was skipped, and why, stands in the reports. */
    @Override
    String toString() {
        String left = skipped > 0 ? "$skipped skipped, for what they read is not on this machine\n" : ''
        failures.collect { it + '\n' }.join('') + left + "$passed passed, $failed failed"
    }
}
